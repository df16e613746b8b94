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

struct Streams {
    std::vector<glm::vec4> positions;
    std::vector<VertexAttributes> attributes;
    std::vector<uint32_t> indices;
    std::vector<MeshRange> ranges;
};

Streams streams_of(const scene::Scene& scene) {
    Streams streams;
    for (const scene::Mesh& mesh : scene.meshes) {
        streams.ranges.push_back({static_cast<uint32_t>(streams.indices.size()),
                                  static_cast<uint32_t>(mesh.indices.size()),
                                  static_cast<int32_t>(streams.positions.size())});
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
    for (const scene::Instance& instance : scene.instances)
        placed.push_back(gpu_instance(instance.transform));

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
    geometry.positions = std::move(*positions);
    geometry.attributes = std::move(*attributes);
    geometry.indices = std::move(*indices);
    geometry.instances = std::move(*instances);
    return geometry;
}

}  // namespace weft::render
