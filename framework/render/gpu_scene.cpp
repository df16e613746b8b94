#include "render/gpu_scene.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <functional>
#include <numeric>

#include "render/imports/material_textures.h"
#include "render/scene_bindings.h"
#include "shared/draw_command.glsl"
#include "vulkan/device/functions.h"
#include "weft/render/import_catalog.h"

namespace weft::render {
namespace {

// The name of the draw list that is drawn from back to front.
constexpr std::string_view kSortedList = "transparent";

constexpr uint32_t kCommandBytes = sizeof(VkDrawIndexedIndirectCommand);
static_assert(sizeof(shared::DrawCommand) == kCommandBytes);

}  // namespace

Result<std::unique_ptr<GpuScene>> GpuScene::create(vk::Device& device, const scene::Scene& scene,
                                                   scene::Scene* owned) {
    std::unique_ptr<GpuScene> gpu(new GpuScene);
    Result<GpuGeometry> geometry = GpuGeometry::create(device, scene);
    if (!geometry) return geometry.take_errors();
    // GpuFrame must be created before GpuMaterials: GpuFrame reads the textures that lights project, and
    // GpuMaterials may free them.
    Result<GpuFrame> frame = GpuFrame::create(device, scene);
    if (!frame) return frame.take_errors();
    Result<GpuMaterials> materials = GpuMaterials::create(device, scene, owned);
    if (!materials) return materials.take_errors();
    const auto slots = static_cast<uint32_t>(geometry->instances.size());
    Result<DescriptorSets> instances = DescriptorSets::create(device, layout_bindings(3), slots, "instances");
    if (!instances) return instances.take_errors();
    gpu->geometry_ = std::move(*geometry);
    gpu->materials_ = std::move(*materials);
    gpu->frame_ = std::move(*frame);
    gpu->instances_ = std::move(*instances);
    for (uint32_t slot = 0; slot < slots; ++slot) {
        const std::array buffers{
            VkDescriptorBufferInfo{gpu->geometry_.instances[slot].handle(), 0, VK_WHOLE_SIZE},
            VkDescriptorBufferInfo{gpu->geometry_.colors.handle(), 0, VK_WHOLE_SIZE},
            VkDescriptorBufferInfo{gpu->geometry_.second_uvs.handle(), 0, VK_WHOLE_SIZE}};
        // One write fills bindings 0, 1 and 2: a Vulkan descriptor write continues in the next binding when a
        // binding is full.
        write_buffers(device, gpu->instances_.sets[slot], 0, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, buffers);
    }
    gpu->moving_ = MovingObjects(scene);
    gpu->sort_draws(scene);
    gpu->find_moving_draws();
    if (Status uploaded = gpu->upload_commands(device); !uploaded) return uploaded.take_errors();
    Result<SceneBuffers> described = SceneBuffers::create(device, scene, gpu->geometry_.meshes);
    if (!described) return described.take_errors();
    gpu->buffers_ = std::move(*described);
    return gpu;
}

void GpuScene::sort_draws(const scene::Scene& scene) {
    for (uint32_t i = 0; i < scene.instances.size(); ++i) {
        const scene::Instance& instance = scene.instances[i];
        const scene::Material& material = scene.materials[instance.material];
        const bool mirrored = glm::determinant(glm::mat3(instance.transform)) < 0;
        const scene::Mesh& mesh = scene.meshes[instance.mesh];
        const glm::vec3 center =
            instance.transform * glm::vec4((mesh.bounds.min + mesh.bounds.max) * 0.5f, 1);
        for (const char* list : kDrawLists)
            if (is_in_draw_list(material, list))
                lists_[list].draws.push_back({geometry_.meshes[instance.mesh], i, instance.material,
                                              draw_variant(material, list), material.double_sided, mirrored,
                                              center, box_in_world(mesh.bounds, instance.transform)});
    }
    // Draws are sorted by material for few state changes. The sort is stable: draws with the same material
    // keep the scene's order, so the picture is always the same.
    for (auto& [name, list] : lists_)
        std::stable_sort(list.draws.begin(), list.draws.end(),
                         [](const Draw& a, const Draw& b) { return a.material < b.material; });
}

void GpuScene::find_moving_draws() {
    std::map<uint32_t, uint32_t> objects;  // From the index of an instance to its moving object.
    for (uint32_t i = 0; i < moving_.all().size(); ++i) objects[moving_.all()[i].instance] = i;
    for (auto& [name, list] : lists_) {
        for (uint32_t i = 0; i < list.draws.size(); ++i) {
            const auto object = objects.find(list.draws[i].instance);
            if (object != objects.end()) list.moving.push_back({i, object->second});
        }
    }
}

void GpuScene::move(uint32_t slot, std::span<const glm::mat4> nodes) {
    if (moving_.all().empty()) return;
    moving_.move(nodes);
    std::byte* memory = geometry_.instances[slot].mapped().data();
    bool any_changed = false;
    for (const MovingObject& object : moving_.all()) {
        shared::Instance instance = gpu_instance(object.transform);
        instance.prev_object_to_world = object.previous;
        // The members after the matrices do not change.
        std::memcpy(memory + uint64_t{object.instance} * sizeof instance, &instance,
                    offsetof(shared::Instance, color_offset));
        any_changed |= object.changed;
    }
    buffers_.move(slot, moving_.all());
    if (any_changed) ++objects_version_;
    for (auto& [name, list] : lists_) {
        bool changed = false;
        for (const MovingDraw& moving : list.moving) {
            const MovingObject& object = moving_.all()[moving.object];
            Draw& draw = list.draws[moving.draw];
            draw.mirrored = glm::determinant(glm::mat3(object.transform)) < 0;
            draw.center =
                object.transform * glm::vec4((object.mesh_bounds.min + object.mesh_bounds.max) * 0.5f, 1);
            draw.box = box_in_world(object.mesh_bounds, object.transform);
            changed |= object.changed;
        }
        if (changed) ++list.version;
    }
}

Status GpuScene::set_frame(uint32_t slot, const shared::FrameConstants& frame,
                           const shared::SunConstants& sun, std::span<const FrameView> views,
                           std::span<const ViewNames> united_views) {
    if (Status written = frame_.write(slot, frame, sun, views, united_views); !written) return written;
    views_.clear();
    for (const FrameView& view : views)
        views_.emplace(view.name, ViewShape{view.mirrored, frustum_of(view.constants)});
    const glm::vec3 eye = views.front().constants.eye;
    const std::vector<Draw>& draws = lists_[std::string(kSortedList)].draws;
    far_to_near_.resize(draws.size());
    std::iota(far_to_near_.begin(), far_to_near_.end(), 0u);
    const auto distance2 = [&](uint32_t i) {
        const glm::vec3 way = draws[i].center - eye;
        return glm::dot(way, way);
    };
    std::ranges::stable_sort(far_to_near_, std::greater{}, distance2);
    return Unit{};
}

uint32_t GpuScene::place_of(std::string_view list, uint32_t i) const {
    return list == kSortedList ? far_to_near_[i] : i;
}

Status GpuScene::upload_commands(vk::Device& device) {
    for (const char* list : kDrawLists) {
        std::vector<shared::DrawCommand> commands;
        for (const Draw& draw : lists_[list].draws)
            commands.push_back(
                {draw.mesh.index_count, 1, draw.mesh.first_index, draw.mesh.vertex_offset, draw.instance});
        // Vulkan has no empty buffers, so an empty list gets one unused command.
        if (commands.empty()) commands.emplace_back();
        const std::span<const std::byte> bytes = std::as_bytes(std::span(commands));
        Result<vk::Buffer> buffer =
            vk::Buffer::create(device, bytes.size(),
                               VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT | VK_BUFFER_USAGE_STORAGE_BUFFER_BIT |
                                   VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                               vk::Buffer::Memory::device, commands_of(list));
        if (!buffer) return buffer.take_errors();
        if (Status copied = vk::upload_buffer(device, *buffer, bytes); !copied) return copied;
        commands_.emplace(list, std::move(*buffer));
    }
    return Unit{};
}

void GpuScene::bind(vk::ImportBindings& to) const {
    for (const auto& [list, buffer] : commands_) to.buffers.emplace(commands_of(list), buffer.handle());
    bind_scene_buffer("instances", geometry_.instances, to);
    buffers_.bind(to);
    to.textures.emplace(kMaterialTextures, materials_.table());
}

void GpuScene::add_versions(std::map<std::string, uint64_t, std::less<>>& to) const {
    for (const auto& [list, unused] : commands_) to.emplace(commands_of(list), 0);
    for (const char* name : kSceneBuffers) to.emplace(name, 0);
    to["instances"] = to["bounds"] = objects_version_;
}

VkDescriptorSetLayout GpuScene::set_layout(uint32_t set) const {
    switch (set) {
        case 0:
            return frame_.layout();
        case 2:
            return materials_.layout();
        case 3:
            return instances_.layout.get();
        default:
            return VK_NULL_HANDLE;
    }
}

VkDescriptorSet GpuScene::frame_set(uint32_t frame_slot, std::string_view view) const {
    return frame_.set(frame_slot, view);
}

Result<std::unique_ptr<vk::ViewSets>> GpuScene::make_view_sets(std::span<const vk::ViewPlace> places) const {
    return frame_.make_view_sets(places);
}

VkDescriptorSet GpuScene::frame_set_of_area(uint32_t frame_slot, std::string_view view,
                                            const LiveArea& area) const {
    return frame_.set(frame_slot, area_view(view, area));
}

VkDescriptorSet GpuScene::views_set(uint32_t frame_slot, std::span<const std::string> views) const {
    return frame_.set(frame_slot, views);
}

bool GpuScene::add_frame_bytes(uint32_t frame_slot, std::string_view view, std::span<const FrameRange> ranges,
                               std::vector<std::byte>& bytes) const {
    frame_.add_bytes(frame_slot, view, ranges, bytes);
    return true;
}

std::optional<uint64_t> GpuScene::list_version(std::string_view list) const {
    if (list == kSortedList) return std::nullopt;
    const auto found = lists_.find(list);
    return found == lists_.end() ? 0 : found->second.version;
}

uint32_t GpuScene::record(const vk::DrawContext& context) const {
    const auto found = lists_.find(context.list);
    if (found == lists_.end()) return 0;
    const vk::DeviceFunctions& fn = *context.fn;
    const VkCommandBuffer commands = context.commands;
    const std::array streams{geometry_.positions.handle(), geometry_.attributes.handle()};
    const std::array<VkDeviceSize, 2> offsets{0, 0};
    fn.vkCmdBindVertexBuffers(commands, 0, static_cast<uint32_t>(streams.size()), streams.data(),
                              offsets.data());
    fn.vkCmdBindIndexBuffer(commands, geometry_.indices.handle(), 0, VK_INDEX_TYPE_UINT32);
    const VkDescriptorSet instances = instances_.sets[instances_.sets.size() > 1 ? context.frame_slot : 0];
    if (context.uses_instances)
        fn.vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, context.layout, 3, 1,
                                   &instances, 0, nullptr);
    if (context.draw_count != VK_NULL_HANDLE) {
        record_counted(context);
        return 0;
    }
    const bool mirrored = is_mirrored(context.view);
    const Frusta frusta = find_frusta(context);
    uint32_t left_out = 0;
    DrawState state;
    const std::vector<Draw>& draws = found->second.draws;
    for (uint32_t i = 0; i < draws.size();) {
        const uint32_t place = place_of(context.list, i);
        const Draw& draw = draws[place];
        const bool outside = is_outside(frusta, draw.box, context.depth_clamp);
        if (draw.variant != context.variant || outside) {
            left_out += draw.variant == context.variant ? 1 : 0;
            ++i;
            continue;
        }
        const uint32_t same = count_alike(context, draws, i, frusta);
        i += same;
        set_state(context, draw, draw.mirrored != mirrored, state);
        if (context.draw_commands != VK_NULL_HANDLE)
            fn.vkCmdDrawIndexedIndirect(
                commands, context.draw_commands,
                context.draw_commands_offset_bytes + VkDeviceSize{place} * kCommandBytes, 1, kCommandBytes);
        else
            fn.vkCmdDrawIndexed(commands, draw.mesh.index_count, same, draw.mesh.first_index,
                                draw.mesh.vertex_offset, draw.instance);
    }
    return left_out;
}

// A shader that does not read the matrix of the view may place vertices anywhere.
Frusta GpuScene::find_frusta(const vk::DrawContext& context) const {
    constexpr uint32_t kMatrix = offsetof(shared::ViewConstants, view_projection);
    const bool reads_matrix = std::ranges::any_of(context.frame_ranges, [](const FrameRange& range) {
        return range.binding == kViewBinding && range.offset_bytes <= kMatrix &&
               kMatrix < range.offset_bytes + range.size_bytes;
    });
    if (!culls_ || !context.culls_draws || !reads_matrix) return {};
    Frusta frusta;
    const auto add = [&](std::string_view name) {
        const auto view = views_.find(name);
        if (view != views_.end()) frusta.push_back(&view->second.frustum);
    };
    if (context.views.empty()) add(context.view);
    for (const std::string& name : context.views) add(name);
    return frusta;
}

// Records one command that draws as many commands of the buffer as the GPU has counted. resolve() ensures
// that the pass culls no faces and reads no materials, so all draws have the same state.
void GpuScene::record_counted(const vk::DrawContext& context) const {
    context.fn->vkCmdSetFrontFace(context.commands, is_mirrored(context.view)
                                                        ? VK_FRONT_FACE_CLOCKWISE
                                                        : VK_FRONT_FACE_COUNTER_CLOCKWISE);
    context.fn->vkCmdDrawIndexedIndirectCount(
        context.commands, context.draw_commands, context.draw_commands_offset_bytes, context.draw_count,
        context.draw_count_offset_bytes, context.most_draws, kCommandBytes);
}

// Returns how many draws one instanced command can draw, starting with the i-th draw. These draws have the
// same mesh and state, their instances have consecutive indices, and none of them is outside of the frustum.
// With indirect drawing the result is 1, because each draw has its own command in the buffer.
uint32_t GpuScene::count_alike(const vk::DrawContext& context, const std::vector<Draw>& draws, uint32_t i,
                               const Frusta& frusta) const {
    if (context.draw_commands != VK_NULL_HANDLE) return 1;
    const Draw& first = draws[place_of(context.list, i)];
    uint32_t count = 1;
    for (; i + count < draws.size(); ++count) {
        const Draw& next = draws[place_of(context.list, i + count)];
        const bool alike = next.mesh == first.mesh && next.instance == first.instance + count &&
                           next.material == first.material && next.variant == first.variant &&
                           next.double_sided == first.double_sided && next.mirrored == first.mirrored &&
                           !is_outside(frusta, next.box, context.depth_clamp);
        if (!alike) break;
    }
    return count;
}

// Records only the state that differs from the previous draw.
void GpuScene::set_state(const vk::DrawContext& context, const Draw& draw, bool clockwise,
                         DrawState& state) const {
    const vk::DeviceFunctions& fn = *context.fn;
    if (context.uses_materials && draw.material != state.material) {
        const VkDescriptorSet set = materials_.set(draw.material);
        fn.vkCmdBindDescriptorSets(context.commands, VK_PIPELINE_BIND_POINT_GRAPHICS, context.layout, 2, 1,
                                   &set, 0, nullptr);
        state.material = draw.material;
    }
    if (state.clockwise != clockwise) {
        fn.vkCmdSetFrontFace(context.commands,
                             clockwise ? VK_FRONT_FACE_CLOCKWISE : VK_FRONT_FACE_COUNTER_CLOCKWISE);
        state.clockwise = clockwise;
    }
    if (context.cull == CullMode::material && state.double_sided != draw.double_sided) {
        fn.vkCmdSetCullMode(context.commands, draw.double_sided ? VK_CULL_MODE_NONE : VK_CULL_MODE_BACK_BIT);
        state.double_sided = draw.double_sided;
    }
}

bool GpuScene::is_mirrored(std::string_view view) const {
    const auto found = views_.find(view);
    return found != views_.end() && found->second.mirrored;
}

uint64_t GpuScene::draw_count(std::string_view list) const {
    const auto found = lists_.find(list);
    return found == lists_.end() ? 0 : found->second.draws.size();
}

}  // namespace weft::render
