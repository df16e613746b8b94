#include "render/gpu_geometry.h"

#include <array>
#include <cmath>
#include <cstddef>

#include "render/frame_data.h"

namespace weft::render {
namespace {

// The attribute stream of import_catalog.cpp.
struct VertexAttributes {
    std::array<int16_t, 4> normal;
    std::array<int16_t, 4> tangent;
    glm::vec2 uv;
};
static_assert(sizeof(VertexAttributes) == 24);

int16_t snorm16(float value) {
    return static_cast<int16_t>(std::lround(glm::clamp(value, -1.0f, 1.0f) * 32767.0f));
}

std::array<int16_t, 4> snorm16(const glm::vec4& v) {
    return {snorm16(v.x), snorm16(v.y), snorm16(v.z), snorm16(v.w)};
}

// An empty scene still has buffers, so that everything can be bound.
template <class T>
Result<vk::Buffer> filled(vk::Device& device, std::vector<T> items, VkBufferUsageFlags usage,
                          const char* name) {
    if (items.empty()) items.emplace_back();
    const std::span<const std::byte> bytes = std::as_bytes(std::span<const T>(items));
    Result<vk::Buffer> buffer = vk::Buffer::create(
        device, bytes.size(), usage | VK_BUFFER_USAGE_TRANSFER_DST_BIT, vk::Buffer::Memory::device, name);
    if (!buffer) return buffer;
    if (Status copied = vk::upload_buffer(device, *buffer, bytes); !copied) return copied.take_errors();
    return buffer;
}

// rgba16, as unpackUnorm2x16 reads it.
std::array<uint16_t, 4> unorm16(const glm::vec4& v) {
    std::array<uint16_t, 4> out{};
    for (int i = 0; i < 4; ++i)
        out[static_cast<size_t>(i)] =
            static_cast<uint16_t>(std::lround(glm::clamp(v[i], 0.0f, 1.0f) * 65535.0f));
    return out;
}

struct Streams {
    std::vector<glm::vec4> positions;
    std::vector<VertexAttributes> attributes;
    std::vector<uint32_t> indices;
    std::vector<std::array<uint16_t, 4>> colors;
    std::vector<glm::vec2> second_uvs;
    std::vector<MeshRange> ranges;
};

// What leads from the vertices' indices to the stream of a mesh that starts at `vertex_offset`.
int32_t stream_offset(bool present, size_t begins, int32_t vertex_offset) {
    return present ? static_cast<int32_t>(begins) - vertex_offset : shared::kNoStream;
}

Streams streams_of(const scene::Scene& scene) {
    Streams streams;
    for (const scene::Mesh& mesh : scene.meshes) {
        const auto vertex_offset = static_cast<int32_t>(streams.positions.size());
        streams.ranges.push_back(
            {static_cast<uint32_t>(streams.indices.size()), static_cast<uint32_t>(mesh.indices.size()),
             vertex_offset, stream_offset(!mesh.colors.empty(), streams.colors.size(), vertex_offset),
             stream_offset(!mesh.second_uvs.empty(), streams.second_uvs.size(), vertex_offset)});
        for (const glm::vec4& color : mesh.colors) streams.colors.push_back(unorm16(color));
        streams.second_uvs.insert(streams.second_uvs.end(), mesh.second_uvs.begin(), mesh.second_uvs.end());
        for (size_t i = 0; i < mesh.positions.size(); ++i) {
            streams.positions.emplace_back(mesh.positions[i], 1.0f);
            streams.attributes.push_back(
                {snorm16(glm::vec4(mesh.normals[i], 0)), snorm16(mesh.tangents[i]), mesh.uvs[i]});
        }
        streams.indices.insert(streams.indices.end(), mesh.indices.begin(), mesh.indices.end());
    }
    return streams;
}

}  // namespace

Result<GpuGeometry> GpuGeometry::create(vk::Device& device, const scene::Scene& scene) {
    Streams streams = streams_of(scene);
    std::vector<shared::Instance> placed;
    placed.reserve(scene.instances.size());
    for (const scene::Instance& instance : scene.instances) {
        placed.push_back(gpu_instance(instance.transform));
        placed.back().color_offset = streams.ranges[instance.mesh].color_offset;
        placed.back().second_uv_offset = streams.ranges[instance.mesh].second_uv_offset;
    }

    GpuGeometry geometry;
    geometry.meshes = std::move(streams.ranges);
    Result<vk::Buffer> positions =
        filled(device, std::move(streams.positions), VK_BUFFER_USAGE_VERTEX_BUFFER_BIT, "scene positions");
    if (!positions) return positions.take_errors();
    Result<vk::Buffer> attributes =
        filled(device, std::move(streams.attributes), VK_BUFFER_USAGE_VERTEX_BUFFER_BIT, "scene attributes");
    if (!attributes) return attributes.take_errors();
    Result<vk::Buffer> indices =
        filled(device, std::move(streams.indices), VK_BUFFER_USAGE_INDEX_BUFFER_BIT, "scene indices");
    if (!indices) return indices.take_errors();
    Result<vk::Buffer> instances =
        filled(device, std::move(placed), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, "scene instances");
    if (!instances) return instances.take_errors();
    Result<vk::Buffer> colors =
        filled(device, std::move(streams.colors), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, "scene vertex colours");
    if (!colors) return colors.take_errors();
    Result<vk::Buffer> second_uvs =
        filled(device, std::move(streams.second_uvs), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, "scene second uvs");
    if (!second_uvs) return second_uvs.take_errors();
    geometry.colors = std::move(*colors);
    geometry.second_uvs = std::move(*second_uvs);
    geometry.positions = std::move(*positions);
    geometry.attributes = std::move(*attributes);
    geometry.indices = std::move(*indices);
    geometry.instances = std::move(*instances);
    return geometry;
}

}  // namespace weft::render
