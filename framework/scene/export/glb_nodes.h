// Purpose: adds the meshes, instances and cameras of a scene to a glTF file.
#pragma once

#include "scene/export/glb_model.h"
#include "weft/scene/scene.h"

namespace tinygltf {
class Node;
}

namespace weft::scene::glb {

// Adds a node to the only scene of the file. `transform`: from the space of the node to world space.
tinygltf::Node& add_node(const std::string& name, const glm::mat4& transform, tinygltf::Model& out);

// Adds a node for each instance. A mesh of glTF names its material, so a mesh of the scene that is used with
// two materials becomes two meshes of the file, which share their vertices and indices.
void add_instances(const Scene& scene, tinygltf::Model& out);

void add_cameras(const std::vector<Camera>& cameras, tinygltf::Model& out);

}  // namespace weft::scene::glb
