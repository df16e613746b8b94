#include "render/gpu_geometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "render/frame_data.h"
#include "weft/vulkan/executor.h"

namespace weft::render {
namespace {

// One vertex of the second vertex stream: normal, tangent and uv as declared in import_catalog.cpp.
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

// Returns a buffer with the items. An empty list gives a buffer with one default item, so that there is
// always a buffer to bind.
template <class T>
Result<vk::Buffer> filled(vk::Device& device, vk::Uploader& uploader, std::vector<T> items,
                          VkBufferUsageFlags usage, const char* name) {
    if (items.empty()) items.emplace_back();
    const std::span<const std::byte> bytes = std::as_bytes(std::span<const T>(items));
    Result<vk::Buffer> buffer = vk::Buffer::create(
        device, bytes.size(), usage | VK_BUFFER_USAGE_TRANSFER_DST_BIT, vk::Buffer::Memory::device, name);
    if (!buffer) return buffer;
    if (Status copied = uploader.buffer(*buffer, bytes); !copied) return copied.take_errors();
    return buffer;
}

// Converts a colour to four 16-bit unorm values, as GLSL's unpackUnorm2x16 reads them.
std::array<uint16_t, 4> unorm16(const glm::vec4& v) {
    std::array<uint16_t, 4> out{};
    for (int i = 0; i < 4; ++i)
        out[static_cast<size_t>(i)] =
            static_cast<uint16_t>(std::lround(glm::clamp(v[i], 0.0f, 1.0f) * 65535.0f));
    return out;
}

// Returns the offset of a mesh for an optional stream: vertex colours or second uvs. gl_VertexIndex plus this
// offset is the index in the stream. The mesh starts at `begins` in the stream and at `vertex_offset` in the
// positions. Returns kNoStream if the mesh has no such data (`present` is false).
int32_t stream_offset(bool present, size_t begins, int32_t vertex_offset) {
    return present ? static_cast<int32_t>(begins) - vertex_offset : shared::kNoStream;
}

std::vector<MeshRange> ranges_of(const scene::Scene& scene) {
    std::vector<MeshRange> ranges;
    size_t vertices = 0, indices = 0, colors = 0, second_uvs = 0;
    for (const scene::Mesh& mesh : scene.meshes) {
        const auto vertex_offset = static_cast<int32_t>(vertices);
        ranges.push_back({static_cast<uint32_t>(indices), static_cast<uint32_t>(mesh.indices.size()),
                          vertex_offset, stream_offset(!mesh.colors.empty(), colors, vertex_offset),
                          stream_offset(!mesh.second_uvs.empty(), second_uvs, vertex_offset)});
        vertices += mesh.positions.size();
        indices += mesh.indices.size();
        colors += mesh.colors.size();
        second_uvs += mesh.second_uvs.size();
    }
    return ranges;
}

// Returns one stream of all meshes, joined. A mesh contributes `count(mesh)` items, and `item(mesh, i)` makes
// the item i.
template <class Count, class Item>
auto joined(const scene::Scene& scene, const Count& count, const Item& item) {
    size_t all = 0;
    for (const scene::Mesh& mesh : scene.meshes) all += count(mesh);
    std::vector<std::decay_t<decltype(item(scene.meshes.front(), size_t{0}))>> stream;
    stream.reserve(all);
    for (const scene::Mesh& mesh : scene.meshes)
        for (size_t i = 0; i < count(mesh); ++i) stream.push_back(item(mesh, i));
    return stream;
}

std::vector<glm::vec4> positions_of(const scene::Scene& scene) {
    return joined(
        scene, [](const scene::Mesh& m) { return m.positions.size(); },
        [](const scene::Mesh& m, size_t i) { return glm::vec4(m.positions[i], 1.0f); });
}

std::vector<VertexAttributes> attributes_of(const scene::Scene& scene) {
    return joined(
        scene, [](const scene::Mesh& m) { return m.positions.size(); },
        [](const scene::Mesh& m, size_t i) {
            return VertexAttributes{snorm16(glm::vec4(m.normals[i], 0)), snorm16(m.tangents[i]), m.uvs[i]};
        });
}

std::vector<uint32_t> indices_of(const scene::Scene& scene) {
    return joined(
        scene, [](const scene::Mesh& m) { return m.indices.size(); },
        [](const scene::Mesh& m, size_t i) { return m.indices[i]; });
}

std::vector<std::array<uint16_t, 4>> colors_of(const scene::Scene& scene) {
    return joined(
        scene, [](const scene::Mesh& m) { return m.colors.size(); },
        [](const scene::Mesh& m, size_t i) { return unorm16(m.colors[i]); });
}

std::vector<glm::vec2> second_uvs_of(const scene::Scene& scene) {
    return joined(
        scene, [](const scene::Mesh& m) { return m.second_uvs.size(); },
        [](const scene::Mesh& m, size_t i) { return m.second_uvs[i]; });
}

std::vector<shared::Instance> instances_of(const scene::Scene& scene, const std::vector<MeshRange>& ranges) {
    std::vector<shared::Instance> placed;
    placed.reserve(scene.instances.size());
    for (const scene::Instance& instance : scene.instances) {
        placed.push_back(gpu_instance(instance.transform));
        placed.back().color_offset = ranges[instance.mesh].color_offset;
        placed.back().second_uv_offset = ranges[instance.mesh].second_uv_offset;
        placed.back().mesh = instance.mesh;
        placed.back().material = instance.material;
    }
    return placed;
}

// Makes the buffers for GpuGeometry::instances.
Result<std::vector<vk::Buffer>> instance_buffers(vk::Device& device, const scene::Scene& scene,
                                                 const std::vector<MeshRange>& ranges, vk::Uploader& uploader,
                                                 bool moves_instances) {
    constexpr VkBufferUsageFlags kStorage =
        VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT;
    std::vector<vk::Buffer> buffers;
    std::vector<shared::Instance> placed = instances_of(scene, ranges);
    const bool moves = moves_instances || std::ranges::any_of(scene.instances, [](const scene::Instance& i) {
                           return i.node != scene::kNone;
                       });
    if (!moves || placed.empty()) {
        Result<vk::Buffer> buffer = filled(device, uploader, std::move(placed), kStorage, "scene instances");
        if (!buffer) return buffer.take_errors();
        buffers.push_back(std::move(*buffer));
        return buffers;
    }
    const std::span<const std::byte> bytes = std::as_bytes(std::span(placed));
    for (uint32_t slot = 0; slot < vk::kFramesInFlight; ++slot) {
        Result<vk::Buffer> buffer =
            vk::Buffer::create(device, bytes.size(), kStorage, vk::Buffer::Memory::upload, "scene instances");
        if (!buffer) return buffer.take_errors();
        std::ranges::copy(bytes, buffer->mapped().begin());
        buffers.push_back(std::move(*buffer));
    }
    return buffers;
}

}  // namespace

// The streams are made one after another. Each stream is freed on the host after its upload and before the
// next stream is made, to save memory.
Result<GpuGeometry> GpuGeometry::create(vk::Device& device, const scene::Scene& scene, vk::Uploader& uploader,
                                        bool moves_instances) {
    GpuGeometry geometry;
    geometry.meshes = ranges_of(scene);
    constexpr VkBufferUsageFlags kVertices = VK_BUFFER_USAGE_VERTEX_BUFFER_BIT,
                                 kIndices = VK_BUFFER_USAGE_INDEX_BUFFER_BIT,
                                 kStorage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
    Result<vk::Buffer> positions =
        filled(device, uploader, positions_of(scene), kVertices, "scene positions");
    if (!positions) return positions.take_errors();
    Result<vk::Buffer> attributes =
        filled(device, uploader, attributes_of(scene), kVertices, "scene attributes");
    if (!attributes) return attributes.take_errors();
    Result<vk::Buffer> indices = filled(device, uploader, indices_of(scene), kIndices, "scene indices");
    if (!indices) return indices.take_errors();
    Result<std::vector<vk::Buffer>> instances =
        instance_buffers(device, scene, geometry.meshes, uploader, moves_instances);
    if (!instances) return instances.take_errors();
    Result<vk::Buffer> colors = filled(device, uploader, colors_of(scene), kStorage, "scene vertex colours");
    if (!colors) return colors.take_errors();
    Result<vk::Buffer> second_uvs =
        filled(device, uploader, second_uvs_of(scene), kStorage, "scene second uvs");
    if (!second_uvs) return second_uvs.take_errors();
    geometry.positions = std::move(*positions);
    geometry.attributes = std::move(*attributes);
    geometry.indices = std::move(*indices);
    geometry.instances = std::move(*instances);
    geometry.colors = std::move(*colors);
    geometry.second_uvs = std::move(*second_uvs);
    return geometry;
}

}  // namespace weft::render
