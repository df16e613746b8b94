// Purpose: adds the materials of a scene to a glTF file.
#pragma once

#include "scene/export/glb_textures.h"

namespace weft::scene::glb {

// Adds one material of the file for each material of the scene, in the same order.
void add_materials(const std::vector<Material>& materials, TextureTable& textures, tinygltf::Model& out);

}  // namespace weft::scene::glb
