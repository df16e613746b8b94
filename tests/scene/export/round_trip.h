// Purpose: compares two scenes, of which one is the other after it was written as a glTF file and loaded
// again.
#pragma once

#include "weft/scene/scene.h"

namespace weft::scene::test {

// Expects that both scenes have the same instances, materials, textures, lights and cameras. Meshes and
// textures may have other indices.
void expect_same_scene(const Scene& written, const Scene& loaded);

}  // namespace weft::scene::test
