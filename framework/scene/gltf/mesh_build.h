// Purpose: glTF primitives to meshes: vertices that triangles use, in one index type, with every stream
// filled. Errors: S104 an accessor past its bytes, S107 over a limit, S111 an index past the vertices.
// Warnings: S151 a primitive that is not made of triangles, S152 what is not finite, S156 nothing left to
// draw.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/gltf/gltf_document.h"
#include "scene/loading/gltf_report.h"
#include "scene/loading/memory_budget.h"
#include "weft/scene/load_gltf.h"

namespace weft::scene::gltf {

struct BuiltPrimitive {
    uint32_t mesh = kNone;      // in BuiltMeshes::meshes
    uint32_t material = kNone;  // glTF material
};

struct BuiltMeshes {
    std::vector<Mesh> meshes;
    std::vector<std::vector<BuiltPrimitive>> of_gltf_mesh;  // what each glTF mesh became
};

// Faults are reported and leave their primitive out.
[[nodiscard]] BuiltMeshes build_meshes(const Document& document, const SceneLimits& limits,
                                       const LoadOptions& options, MemoryBudget& memory, Report& report);

}  // namespace weft::scene::gltf
