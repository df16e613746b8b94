// Purpose: makes the reflection probes of a scene from the nodes that have `extras.weft.probe`. Warning: S198
// a probe that is ignored, because its box is flat or because the scene has too many probes.
#pragma once

#include "scene/gltf/mesh_build.h"

namespace weft::scene::gltf {

// A node at its place in the scene.
struct PlacedNode {
    uint32_t index = 0;
    glm::mat4 world{1};
};

// Adds the probe of the node to the scene, if the node has one.
void place_probe(const Document& document, const BuiltMeshes& meshes, const PlacedNode& placed,
                 Report& report, Scene& scene);

}  // namespace weft::scene::gltf
