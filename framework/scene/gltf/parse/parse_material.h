// Purpose: converts a material of tinygltf, with its texture references and extensions.
#pragma once

#include "weft/scene/scene.h"

namespace tinygltf {
struct Material;
class Model;
}  // namespace tinygltf

namespace weft::scene::gltf {

[[nodiscard]] Material convert_material(const tinygltf::Material& source, const tinygltf::Model& model);

}  // namespace weft::scene::gltf
