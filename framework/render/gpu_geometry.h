// Purpose: a scene's meshes in GPU memory, in the vertex format of import_catalog.h. One buffer contains the
// positions of all meshes, another one the attributes, and so on for indices and instances. Few meshes have
// vertex colours or second uvs. So each of these two buffers contains only the meshes that have such data.
// Errors: those of vk::Buffer::create() and upload_buffer().
#pragma once

#include <vector>

#include "weft/scene/scene.h"
#include "weft/vulkan/memory.h"

namespace weft::render {

struct MeshRange {
    uint32_t first_index = 0;
    uint32_t index_count = 0;
    int32_t vertex_offset = 0;
    // Vertex index + color_offset = index of the vertex colour, as in shared::Instance. kNoStream if the mesh
    // has no vertex colours.
    int32_t color_offset = 0;
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
    // The place of each mesh in the buffers, in the order of scene::Scene::meshes.
    std::vector<MeshRange> meshes;

    [[nodiscard]] static Result<GpuGeometry> create(vk::Device& device, const scene::Scene& scene);
};

}  // namespace weft::render
