// Purpose: converts the node tree of a glTF to instances, lights and cameras in world space. Errors: S107 too
// many instances, or too much memory. Warnings: S152 a transform that is too large or not finite.
#pragma once

#include "scene/gltf/gltf_document.h"
#include "scene/gltf/mesh_build.h"
#include "scene/loading/gltf_report.h"
#include "scene/loading/memory_budget.h"
#include "weft/scene/load_gltf.h"

namespace weft::scene::gltf {

// Fills the instances, lights and cameras of the scene. Primitives without a material get `default_material`.
void place_nodes(const Document& document, const BuiltMeshes& meshes, uint32_t default_material,
                 const SceneLimits& limits, MemoryBudget& memory, Report& report, Scene& scene);

}  // namespace weft::scene::gltf
