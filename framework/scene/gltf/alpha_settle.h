// Purpose: makes a material opaque if it is marked as transparent but its alpha is 1 everywhere.
#pragma once

#include <vector>

#include "scene/gltf/mesh_build.h"

namespace weft::scene::gltf {

// Changes AlphaMode::blend to AlphaMode::opaque if the alpha of a material is 1 everywhere. The surfaces look
// the same, but now graphs that draw no transparent surfaces show them too. Alpha is the product of material
// factor, texture and vertex colour. The texture slots in `materials` must already contain indices of scene
// textures.
void settle_alpha(const BuiltMeshes& built, const std::vector<Texture>& textures,
                  std::vector<Material>& materials);

}  // namespace weft::scene::gltf
