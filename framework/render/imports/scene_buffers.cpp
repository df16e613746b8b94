#include "render/imports/scene_buffers.h"

#include <algorithm>
#include <cstring>

#include "render/frame_data.h"
#include "render/imports/material_textures.h"
#include "render/views/frustum.h"

namespace weft::render {
namespace {

static_assert(sizeof(shared::Bounds) == 32 && sizeof(shared::Mesh) == 48);

shared::Bounds gpu_bounds(const scene::Bounds& mesh, const glm::mat4& to_world) {
    const scene::Bounds box = box_in_world(mesh, to_world);
    return {box.min, 0, box.max, 0};
}

constexpr VkBufferUsageFlags kBufferUsage =
    VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;

template <class T>
Result<vk::Buffer> uploaded(vk::Device& device, std::vector<T> items, const std::string& name) {
    // Vulkan has no empty buffers, so an empty list gives one element with the value 0.
    if (items.empty()) items.emplace_back();
    return make_scene_buffer(device, std::as_bytes(std::span<const T>(items)), name);
}

Result<std::vector<vk::Buffer>> bounds_buffers(vk::Device& device, const scene::Scene& scene,
                                               bool moves_instances) {
    const auto follows = [](const scene::Instance& instance) { return instance.node != scene::kNone; };
    const bool moves =
        !scene.instances.empty() && (moves_instances || std::ranges::any_of(scene.instances, follows));
    const std::vector<shared::Bounds> boxes = instance_bounds(scene);
    std::vector<vk::Buffer> buffers;
    for (uint32_t slot = 0; slot < (moves ? vk::kFramesInFlight : 1); ++slot) {
        const std::span<const std::byte> bytes = std::as_bytes(std::span(boxes));
        Result<vk::Buffer> buffer = moves ? vk::Buffer::create(device, bytes.size(), kBufferUsage,
                                                               vk::Buffer::Memory::upload, "scene bounds")
                                          : uploaded(device, boxes, "bounds");
        if (!buffer) return buffer.take_errors();
        if (moves) std::ranges::copy(bytes, buffer->mapped().begin());
        buffers.push_back(std::move(*buffer));
    }
    return buffers;
}

}  // namespace

// The program writes the buffers before the first frame, and passes only read them. So no access is pending
// before or after a frame.
ImportDecl scene_buffer(const std::string& name, size_t elements, size_t stride_bytes) {
    ImportDecl import;
    import.name = name;
    import.kind = ImportKind::buffer;
    import.read_only = true;
    ResourceDecl& buffer = import.resource;
    buffer.name = name;
    buffer.kind = ResourceKind::buffer;
    buffer.lifetime = ResourceLifetime::imported;
    buffer.stride_bytes = static_cast<uint32_t>(stride_bytes);
    buffer.size_bytes = std::max<uint64_t>(1, elements) * stride_bytes;
    buffer.usage = usage::kStorage | usage::kTransferSrc;
    buffer.import = ImportState{};
    return import;
}

Result<vk::Buffer> make_scene_buffer(vk::Device& device, std::span<const std::byte> bytes,
                                     const std::string& name) {
    Result<vk::Buffer> buffer =
        vk::Buffer::create(device, bytes.size(), kBufferUsage, vk::Buffer::Memory::device, "scene " + name);
    if (!buffer) return buffer;
    if (Status copied = vk::upload_buffer(device, *buffer, bytes); !copied) return copied.take_errors();
    return buffer;
}

void add_scene_buffers(ImportCatalog& catalog, const scene::Scene* scene) {
    const size_t instances = scene != nullptr ? scene->instances.size() : 1;
    const size_t meshes = scene != nullptr ? scene->meshes.size() : 1;
    const size_t materials = scene != nullptr ? scene->materials.size() : 1;
    const auto add = [&](const std::string& name, const char* element, size_t count, size_t stride_bytes) {
        catalog.imports.emplace(name, scene_buffer(name, count, stride_bytes));
        catalog.strides.emplace(element, static_cast<uint32_t>(stride_bytes));
    };
    add("instances", "Instance", instances, sizeof(shared::Instance));
    add("bounds", "Bounds", instances, sizeof(shared::Bounds));
    add("meshes", "Mesh", meshes, sizeof(shared::Mesh));
    add("materials", "Material", materials, sizeof(shared::Material));
    catalog.numbers.emplace("instanceCount", static_cast<double>(instances));
    catalog.numbers.emplace("meshCount", static_cast<double>(meshes));
    catalog.numbers.emplace("materialCount", static_cast<double>(materials));
}

std::vector<shared::Bounds> instance_bounds(const scene::Scene& scene) {
    std::vector<shared::Bounds> all;
    all.reserve(scene.instances.size());
    for (const scene::Instance& instance : scene.instances)
        all.push_back(gpu_bounds(scene.meshes[instance.mesh].bounds, instance.transform));
    return all;
}

std::vector<shared::Mesh> mesh_table(const scene::Scene& scene, const std::vector<MeshRange>& ranges) {
    std::vector<shared::Mesh> table;
    table.reserve(scene.meshes.size());
    for (size_t i = 0; i < scene.meshes.size(); ++i) {
        const scene::Mesh& mesh = scene.meshes[i];
        table.push_back({mesh.bounds.min, ranges[i].first_index, mesh.bounds.max, ranges[i].index_count,
                         ranges[i].vertex_offset, static_cast<uint32_t>(mesh.positions.size()), 0, 0});
    }
    return table;
}

Result<SceneBuffers> SceneBuffers::create(vk::Device& device, const scene::Scene& scene,
                                          const std::vector<MeshRange>& ranges, bool moves_instances) {
    SceneBuffers out;
    Result<std::vector<vk::Buffer>> bounds = bounds_buffers(device, scene, moves_instances);
    if (!bounds) return bounds.take_errors();
    out.bounds_ = std::move(*bounds);
    Result<vk::Buffer> meshes = uploaded(device, mesh_table(scene, ranges), "meshes");
    if (!meshes) return meshes.take_errors();
    out.buffers_.emplace("meshes", std::move(*meshes));
    Result<vk::Buffer> constants = uploaded(device, gpu_materials(scene), "materials");
    if (!constants) return constants.take_errors();
    out.buffers_.emplace("materials", std::move(*constants));
    return out;
}

void SceneBuffers::move(uint32_t slot, const MovingObjects& objects) {
    std::byte* memory = bounds_[slot].mapped().data();
    for (const uint32_t index : objects.active()) {
        const MovingObject& object = objects.all()[index];
        const shared::Bounds box = gpu_bounds(object.mesh_bounds, object.transform);
        std::memcpy(memory + uint64_t{object.instance} * sizeof box, &box, sizeof box);
    }
}

void SceneBuffers::bind(vk::ImportBindings& to) const {
    bind_scene_buffer("bounds", bounds_, to);
    for (const auto& [name, buffer] : buffers_) to.buffers.emplace(name, buffer.handle());
}

void bind_scene_buffer(const std::string& name, const std::vector<vk::Buffer>& slots,
                       vk::ImportBindings& to) {
    if (slots.size() == 1) {
        to.buffers.emplace(name, slots.front().handle());
        return;
    }
    for (size_t slot = 0; slot < slots.size(); ++slot) to.slot_buffers[name][slot] = slots[slot].handle();
}

}  // namespace weft::render
