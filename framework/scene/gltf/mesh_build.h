// Purpose: converts glTF primitives to meshes that contain only used vertices, have one index type, and have
// every stream filled. Errors: S104 an accessor past its bytes, S107 over a limit, S111 an index past the
// vertices. Warnings: S151 a primitive that is not made of triangles, S152 a value that is not finite, S156
// no triangles remain.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/gltf/gltf_document.h"
#include "scene/loading/gltf_report.h"
#include "scene/loading/memory_budget.h"
#include "weft/scene/load_gltf.h"

namespace weft::scene::gltf {

struct BuiltPrimitive {
    uint32_t mesh = kNone;      // index into BuiltMeshes::meshes
    uint32_t material = kNone;  // index of the glTF material
};

struct BuiltMeshes {
    std::vector<Mesh> meshes;
    std::vector<std::vector<BuiltPrimitive>> of_gltf_mesh;  // for each glTF mesh, the primitives built from
                                                            // it
};

// A primitive with a fault is reported and skipped.
[[nodiscard]] BuiltMeshes build_meshes(const Document& document, const SceneLimits& limits,
                                       const LoadOptions& options, MemoryBudget& memory, Report& report);

}  // namespace weft::scene::gltf
