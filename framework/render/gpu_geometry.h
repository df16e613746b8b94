// Purpose: a scene's meshes in GPU memory, in the vertex format of import_catalog.h: one buffer each for
// positions, attributes, indices and instances. Vertex colours and second uvs, which few meshes have, are in
// buffers that contain only those meshes. Errors: those of vk::Buffer and the upload.
#pragma once

#include <vector>

#include "weft/scene/scene.h"
#include "weft/vulkan/memory.h"

namespace weft::render {

struct MeshRange {
    uint32_t first_index = 0;
    uint32_t index_count = 0;
    int32_t vertex_offset = 0;
    int32_t color_offset = 0;  // as in shared::Instance
    int32_t second_uv_offset = 0;

    friend bool operator==(const MeshRange&, const MeshRange&) = default;
};

struct GpuGeometry {
    vk::Buffer positions;
    vk::Buffer attributes;
    vk::Buffer indices;
    vk::Buffer instances;
    vk::Buffer colors;
    vk::Buffer second_uvs;
    std::vector<MeshRange> meshes;  // index: as in scene::Scene::meshes

    [[nodiscard]] static Result<GpuGeometry> create(vk::Device& device, const scene::Scene& scene);
};

}  // namespace weft::render
