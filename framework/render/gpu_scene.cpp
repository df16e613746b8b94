#include "render/gpu_scene.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>

#include "render/imports/material_textures.h"
#include "render/scene_bindings.h"
#include "shared/draw_command.glsl"
#include "vulkan/device/functions.h"
#include "weft/render/import_catalog.h"

namespace weft::render {
namespace {

// The name of the draw list that is drawn from back to front.
constexpr std::string_view kSortedList = "transparent";

// Returns all draws of a list of a part, in the order of the list.
DrawRun whole_run(const GpuPart& part, const PartDrawList& list, bool has_commands) {
    return {&part, &list.draws, std::nullopt, has_commands};
}

}  // namespace

Result<std::unique_ptr<GpuScene>> GpuScene::create(vk::Device& device, const scene::Scene& scene,
                                                   const SceneSettings& settings, scene::Scene* owned) {
    std::unique_ptr<GpuScene> gpu(new GpuScene);
    // GpuFrame must be created before the first part: GpuFrame reads the textures that lights project, and
    // the part may free them.
    Result<GpuFrame> frame = GpuFrame::create(device, scene);
    if (!frame) return frame.take_errors();
    vk::ImmediateUploader uploader(device);
    Result<std::unique_ptr<GpuPart>> part =
        GpuPart::create({device, scene, owned, uploader, settings.moves_instances, true});
    if (!part) return part.take_errors();
    Result<GpuProbes> probes = GpuProbes::create(device, settings.probes);
    if (!probes) return probes.take_errors();
    Result<SceneBuffers> described =
        SceneBuffers::create(device, scene, (*part)->geometry().meshes, settings.moves_instances);
    if (!described) return described.take_errors();
    Result<SceneLights> lights = SceneLights::create(device, scene_light_capacity(&scene));
    if (!lights) return lights.take_errors();
    gpu->frame_ = std::move(*frame);
    gpu->parts_.add_first(std::move(*part));
    gpu->buffers_ = std::move(*described);
    gpu->probes_ = std::move(*probes);
    gpu->lights_ = std::move(*lights);
    gpu->settings_ = settings;
    gpu->find_drawn_variants();
    if (Status uploaded = gpu->upload_commands(device); !uploaded) return uploaded.take_errors();
    return gpu;
}

void GpuScene::begin_frame(uint32_t slot, double time_s) {
    parts_.begin_frame(slot, time_s);
    const MovingObjects& moving = first().moving();
    if (moving.active().empty()) return;
    buffers_.move(slot, moving);
    if (moving.any_changed()) ++objects_version_;
}

std::optional<scene::Bounds> GpuScene::bounds() const {
    std::optional<scene::Bounds> all;
    parts_.each([&](const GpuPart& part) { all = united(all, part.bounds()); });
    for (const auto& [name, own] : settings_.draw_lists) all = united(all, own.list->bounds());
    return all;
}

std::optional<scene::Bounds> GpuScene::still_bounds() const {
    std::optional<scene::Bounds> all;
    parts_.each([&](const GpuPart& part) { all = united(all, part.still_bounds()); });
    return all;
}

std::optional<scene::Bounds> GpuScene::unknown_bounds() const {
    std::optional<scene::Bounds> all;
    parts_.each([&](const GpuPart& part) {
        if (part.still_surfaces().empty()) all = united(all, part.moving().bounds());
    });
    for (const auto& [name, own] : settings_.draw_lists) all = united(all, own.list->bounds());
    return all;
}

bool GpuScene::has_unbounded_lists() const {
    return std::ranges::any_of(settings_.draw_lists,
                               [](const auto& own) { return !own.second.list->bounds(); });
}

Status GpuScene::set_frame(uint32_t slot, const shared::FrameConstants& frame,
                           const shared::SunConstants& sun, const shared::FurtherSuns& further_suns,
                           std::span<const FrameView> views, std::span<const ViewNames> united_views) {
    if (Status written = frame_.write(slot, frame, sun, further_suns, views, united_views); !written)
        return written;
    const auto fixed = std::ranges::find_if(views, [](const FrameView& view) { return view.fixed != 0; });
    const uint64_t fixed_now = fixed != views.end() ? fixed->fixed : 0;
    const bool keeps_fixed = std::exchange(fixed_views_, fixed_now) == fixed_now && fixed_now != 0;
    if (!keeps_fixed) views_.clear();
    for (const FrameView& view : views)
        if (view.fixed == 0 || !keeps_fixed)
            views_.insert_or_assign(view.name, ViewShape{view.mirrored, view.constants.view_projection,
                                                         frustum_of(view.constants)});
    sort_transparent(views.front().constants.eye);
    return Unit{};
}

// Draws at the same distance stay in the order of their parts, and within a part in the order of its list.
void GpuScene::sort_transparent(const glm::vec3& eye) {
    struct Sorted {
        float distance2 = 0;
        const GpuPart* part = nullptr;
        uint32_t draw = 0;
    };
    std::vector<Sorted> all;
    parts_.each([&](const GpuPart& part) {
        const PartDrawList* list = part.list(kSortedList);
        if (list == nullptr) return;
        for (uint32_t i = 0; i < list->draws.size(); ++i) {
            const glm::vec3 way = list->draws[i].center - eye;
            all.push_back({glm::dot(way, way), &part, i});
        }
    });
    std::ranges::stable_sort(all, std::greater{}, &Sorted::distance2);
    far_to_near_.clear();
    sorted_runs_.clear();
    for (const Sorted& next : all) {
        if (sorted_runs_.empty() || sorted_runs_.back().part != next.part)
            sorted_runs_.push_back({next.part, static_cast<uint32_t>(far_to_near_.size()), 0});
        ++sorted_runs_.back().count;
        far_to_near_.push_back(next.draw);
    }
}

Status GpuScene::upload_commands(vk::Device& device) {
    for (const char* list : kCommandLists) {
        std::vector<shared::DrawCommand> commands;
        if (const PartDrawList* draws = first().list(list))
            for (const PartDraw& draw : draws->draws)
                commands.push_back({draw.mesh.index_count, 1, draw.mesh.first_index, draw.mesh.vertex_offset,
                                    draw.instance});
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
    bind_scene_buffer("instances", first().geometry().instances, to);
    buffers_.bind(to);
    probes_.bind(to);
    lights_.bind(to);
    to.textures.emplace(kMaterialTextures, first().material_table());
}

void GpuScene::add_versions(std::map<std::string, uint64_t, std::less<>>& to) const {
    for (const auto& [list, unused] : commands_) to.emplace(commands_of(list), 0);
    for (const char* name : kSceneBuffers) to.emplace(name, 0);
    to["instances"] = to["bounds"] = objects_version_;
    GpuProbes::add_versions(to);
    lights_.add_versions(to);
}

VkDescriptorSetLayout GpuScene::set_layout(uint32_t set) const {
    if (const auto own = settings_.draw_sets.find(set); own != settings_.draw_sets.end())
        return own->second.layout;
    switch (set) {
        case 0:
            return frame_.layout();
        case 2:
            return first().material_layout();
        case 3:
            return first().draw_layout();
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
    const auto own = settings_.draw_lists.find(list);
    if (own != settings_.draw_lists.end()) return own->second.list->version();
    if (list == kSortedList) return std::nullopt;
    return parts_.version(list);
}

uint32_t GpuScene::record(const vk::DrawContext& context) const {
    if (const auto own = settings_.draw_lists.find(context.list); own != settings_.draw_lists.end())
        return record_own(context, *own->second.list);
    DrawRecorder recorder(context, find_frusta(context), is_mirrored(context.view));
    if (context.list == kSortedList && context.draw_count == VK_NULL_HANDLE)
        return record_sorted(context, recorder);
    uint32_t left_out = 0;
    parts_.each([&](const GpuPart& part) {
        const PartDrawList* list = part.list(context.list);
        if (list == nullptr) return;
        // Only the draws of the first part have draw commands in buffers, for indirect drawing.
        const bool is_first = &part == &first();
        if (is_first && context.draw_count != VK_NULL_HANDLE)
            recorder.record_counted(part);
        else
            left_out +=
                recorder.record(whole_run(part, *list, is_first && context.draw_commands != VK_NULL_HANDLE));
    });
    return left_out;
}

uint32_t GpuScene::record_own(const vk::DrawContext& context, const DrawList& list) const {
    const auto matrix = [&](std::string_view name) {
        const auto view = views_.find(name);
        return view != views_.end() ? view->second.view_projection : glm::mat4(1);
    };
    DrawView view{matrix(context.view), is_mirrored(context.view), {}};
    std::vector<glm::mat4> all;
    for (const std::string& name : context.views) all.push_back(matrix(name));
    view.all_view_projections = all;
    return list.record(context, view);
}

uint32_t GpuScene::record_sorted(const vk::DrawContext& context, DrawRecorder& recorder) const {
    uint32_t left_out = 0;
    for (const SortedRun& run : sorted_runs_) {
        DrawRun draws = whole_run(*run.part, *run.part->list(kSortedList),
                                  run.part == &first() && context.draw_commands != VK_NULL_HANDLE);
        draws.order = std::span<const uint32_t>(far_to_near_).subspan(run.first, run.count);
        left_out += recorder.record(draws);
    }
    return left_out;
}

// Returns no frustums for a shader that does not read the matrix of the view, because the shader may place
// vertices anywhere.
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

bool GpuScene::is_mirrored(std::string_view view) const {
    const auto found = views_.find(view);
    return found != views_.end() && found->second.mirrored;
}

void GpuScene::find_drawn_variants() {
    for (const char* name : kDrawLists)
        if (const PartDrawList* list = first().list(name))
            for (const PartDraw& draw : list->draws) drawn_variants_[name].insert(draw.variant);
}

bool GpuScene::draws_variant(std::string_view list, uint32_t variant) const {
    if (takes_parts() || settings_.draw_lists.contains(list)) return true;
    const auto found = drawn_variants_.find(list);
    return found != drawn_variants_.end() && found->second.contains(variant);
}

uint64_t GpuScene::draw_count(std::string_view list) const {
    if (const auto own = settings_.draw_lists.find(list); own != settings_.draw_lists.end())
        return own->second.list->count();
    uint64_t count = 0;
    parts_.each([&](const GpuPart& part) {
        if (const PartDrawList* draws = part.list(list)) count += draws->draws.size();
    });
    return count;
}

}  // namespace weft::render
