// Purpose: converts glTF primitives to meshes. The meshes contain only used vertices and have 32-bit indices,
// positions, normals, tangents and uvs. Errors: S104 an accessor past the end of its bytes, S107 over a
// limit, S111 an index that is too large. Warnings: S151 a primitive that is not made of triangles, S152 a
// value that is not finite, S154 a colour that was clamped, S156 no positions or an incomplete last triangle,
// S160 no second set of texture coordinates.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/gltf/gltf_document.h"
#include "scene/loading/gltf_report.h"
#include "scene/loading/memory_budget.h"
#include "weft/scene/load_gltf.h"

namespace weft::scene::gltf {

struct BuiltPrimitive {
    uint32_t mesh = kNone;      // Index into BuiltMeshes::meshes.
    uint32_t material = kNone;  // Index of the primitive's material in the glTF file, or kNone.
};

struct BuiltMeshes {
    std::vector<Mesh> meshes;
    // For each glTF mesh, the primitives that were built from it. A glTF mesh may have several primitives.
    std::vector<std::vector<BuiltPrimitive>> of_gltf_mesh;
};

// Builds a mesh from every primitive. A primitive with a fault is reported and skipped. After a limit is
// exceeded, no more meshes are built.
[[nodiscard]] BuiltMeshes build_meshes(const Document& document, const SceneLimits& limits,
                                       const LoadOptions& options, MemoryBudget& memory, Report& report);

}  // namespace weft::scene::gltf
