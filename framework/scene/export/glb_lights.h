// Purpose: adds the lights of a scene to a glTF file, with KHR_lights_punctual. The properties that this
// extension cannot express are in `extras.weft`.
#pragma once

#include "scene/export/glb_textures.h"

namespace weft::scene::glb {

// Adds a light and a node for each light of the scene, in the same order. A light with a path has its place
// at time 0.
void add_lights(const Scene& scene, TextureTable& textures, tinygltf::Model& out);

}  // namespace weft::scene::glb
