#include "render/imports/scene_buffers.h"

#include <algorithm>
#include <span>

#include "render/frame_data.h"

namespace weft::render {
namespace {

static_assert(sizeof(shared::Bounds) == 32 && sizeof(shared::Mesh) == 48);

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

template <class T>
Status upload(vk::Device& device, std::vector<T> items, const std::string& name,
              std::map<std::string, vk::Buffer, std::less<>>& to) {
    // Vulkan has no empty buffers, so an empty list gives one element with the value 0.
    if (items.empty()) items.emplace_back();
    const std::span<const std::byte> bytes = std::as_bytes(std::span<const T>(items));
    Result<vk::Buffer> buffer =
        vk::Buffer::create(device, bytes.size(),
                           VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT |
                               VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                           vk::Buffer::Memory::device, "scene " + name);
    if (!buffer) return buffer.take_errors();
    if (Status copied = vk::upload_buffer(device, *buffer, bytes); !copied) return copied;
    to.emplace(name, std::move(*buffer));
    return Unit{};
}

}  // namespace

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
    for (const scene::Instance& instance : scene.instances) {
        const scene::Bounds& box = scene.meshes[instance.mesh].bounds;
        // Arvo 1990, "Transforming Axis-Aligned Bounding Boxes": the centre is transformed, and the half size
        // by the absolute values of the matrix.
        const glm::vec3 centre = instance.transform * glm::vec4((box.min + box.max) * 0.5f, 1);
        const glm::vec3 half = (box.max - box.min) * 0.5f;
        glm::vec3 reach(0);
        for (int column = 0; column < 3; ++column)
            reach += glm::abs(glm::vec3(instance.transform[column])) * half[column];
        all.push_back({centre - reach, 0, centre + reach, 0});
    }
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
                                          const std::vector<MeshRange>& ranges) {
    std::vector<shared::Material> materials;
    materials.reserve(scene.materials.size());
    for (const scene::Material& material : scene.materials) materials.push_back(gpu_material(material));
    SceneBuffers out;
    Status done = upload(device, instance_bounds(scene), "bounds", out.buffers_);
    if (done) done = upload(device, mesh_table(scene, ranges), "meshes", out.buffers_);
    if (done) done = upload(device, std::move(materials), "materials", out.buffers_);
    if (!done) return done.take_errors();
    return out;
}

}  // namespace weft::render
