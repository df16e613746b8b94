// Purpose: transparent materials that let nothing through become opaque ones.
#pragma once

#include <vector>

#include "scene/gltf/mesh_build.h"

namespace weft::scene::gltf {

// Blending with an alpha of 1 is the same picture, and opaque surfaces are drawn by every graph. The alpha is
// that of factor, texture and vertex colours; `materials` hold texture indices of the scene.
void settle_alpha(const BuiltMeshes& built, const std::vector<Texture>& textures,
                  std::vector<Material>& materials);

}  // namespace weft::scene::gltf
