// Purpose: a scene's meshes and instances in GPU memory, in the vertex format of import_catalog.cpp. One
// buffer contains the positions of all meshes. There are such buffers for attributes and for indices, too.
// Few meshes have vertex colours or second uvs. So the two buffers for these contain only the meshes that
// have such data. One buffer contains the instances.
// Errors: those of vk::Buffer::create() and upload_buffer().
#pragma once

#include <vector>

#include "vulkan/memory/uploader.h"
#include "weft/scene/scene.h"
#include "weft/vulkan/memory.h"

namespace weft::render {

struct MeshRange {
    uint32_t first_index = 0;
    uint32_t index_count = 0;
    int32_t vertex_offset = 0;
    // gl_VertexIndex + color_offset = index of the vertex colour, as in shared::Instance. kNoStream if the
    // mesh has no vertex colours.
    int32_t color_offset = 0;
    int32_t second_uv_offset = 0;  // Like color_offset, but for the second uvs.

    friend bool operator==(const MeshRange&, const MeshRange&) = default;
};

struct GpuGeometry {
    vk::Buffer positions;
    vk::Buffer attributes;
    vk::Buffer indices;
    // One buffer for all frames, or if objects of the scene move, one mapped buffer per frame slot.
    std::vector<vk::Buffer> instances;
    vk::Buffer colors;
    vk::Buffer second_uvs;
    // The place of each mesh in the buffers, in the order of scene::Scene::meshes.
    std::vector<MeshRange> meshes;

    // If `moves_instances` is true, or if a node moves an instance, each frame slot has its own instances.
    [[nodiscard]] static Result<GpuGeometry> create(vk::Device& device, const scene::Scene& scene,
                                                    vk::Uploader& uploader, bool moves_instances);
};

}  // namespace weft::render
