// Purpose: makes materials opaque that are marked as transparent but have an alpha of 1 everywhere.
#pragma once

#include <vector>

#include "scene/gltf/mesh_build.h"

namespace weft::scene::gltf {

// Makes materials opaque that are marked as transparent but have an alpha of 1 everywhere. Their surfaces
// look the same either way. But every graph draws opaque surfaces, and only some graphs draw transparent
// ones. Alpha is the product of material factor, texture and vertex colour. The texture slots in `materials`
// must already contain indices of scene textures.
void settle_alpha(const BuiltMeshes& built, const std::vector<Texture>& textures,
                  std::vector<Material>& materials);

}  // namespace weft::scene::gltf
