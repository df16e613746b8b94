#include "scene/gltf/probe_build.h"

#include <algorithm>

#include "scene/model/node_placement.h"

namespace weft::scene::gltf {
namespace {

// A box is flat if one of its sides is shorter than this, in metres.
constexpr float kFlat_m = 0.01f;

// Returns the box of a node in the space of the node: the bounds of the mesh of the node, or the cube from −1
// to 1 if the node has no mesh.
Bounds box_of_node(const Node& node, const BuiltMeshes& meshes) {
    if (node.mesh == kNone || meshes.of_gltf_mesh[node.mesh].empty()) return {glm::vec3(-1), glm::vec3(1)};
    Bounds box = meshes.meshes[meshes.of_gltf_mesh[node.mesh].front().mesh].bounds;
    for (const BuiltPrimitive& primitive : meshes.of_gltf_mesh[node.mesh]) {
        const Bounds& part = meshes.meshes[primitive.mesh].bounds;
        box = {glm::min(box.min, part.min), glm::max(box.max, part.max)};
    }
    return box;
}

}  // namespace

void place_probe(const Document& document, const BuiltMeshes& meshes, const PlacedNode& placed,
                 Report& report, Scene& scene) {
    const auto found = document.probes.find(placed.index);
    if (found == document.probes.end()) return;
    const Node& node = document.nodes[placed.index];
    const std::string pointer = "/nodes/" + std::to_string(placed.index) + "/extras/weft/probe";
    if (scene.probes.reflections.size() >= kMostReflectionProbes) {
        report.warn("S198", pointer,
                    "the scene has more than " + std::to_string(kMostReflectionProbes) +
                        " reflection probes; this one is ignored",
                    "use larger boxes and fewer probes");
        return;
    }
    const Bounds local = box_of_node(node, meshes);
    const glm::vec3 middle = (local.min + local.max) * 0.5f, half = (local.max - local.min) * 0.5f;
    ProbeBox box;
    box.center = glm::vec3(placed.world * glm::vec4(middle, 1));
    for (int axis = 0; axis < 3; ++axis)
        box.half_size_m[axis] = half[axis] * glm::length(glm::vec3(placed.world[axis]));
    if (std::min({box.half_size_m.x, box.half_size_m.y, box.half_size_m.z}) < kFlat_m / 2) {
        report.warn("S198", pointer, "the box of the probe is flat, so the probe is ignored",
                    "give the node a scale or a mesh with three dimensions");
        return;
    }
    box.rotation = glm::quat_cast(glm::mat3(rigid_transform(placed.world)));
    ReflectionProbe probe;
    probe.name = label("node", placed.index, node.name);
    if (!node.name.empty()) probe.name = node.name;
    probe.position = glm::vec3(placed.world * glm::vec4(found->second.position.value_or(middle), 1));
    probe.box = box;
    scene.probes.reflections.push_back(std::move(probe));
}

}  // namespace weft::scene::gltf
