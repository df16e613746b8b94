#include "render/views/frame_views.h"

#include <algorithm>
#include <set>

#include "graph/diagnostics/make_error.h"
#include "graph/parse/debug_view.h"

namespace weft::render {
namespace {

constexpr const char* kCamera = "camera";
constexpr const char* kSun = "sun";

// The two parts of the name of a view: "sun" and 1 for "sun(1)".
struct ViewName {
    std::string list;
    uint32_t index = 0;
};

ViewName parts_of(const std::string& view) {
    const size_t open = view.find('(');
    if (open == std::string::npos) return {view, 0};
    return {view.substr(0, open), static_cast<uint32_t>(std::stoul(view.substr(open + 1)))};
}

glm::uvec2 size_of(const PassDecl& pass) {
    if (pass.kind != PassKind::raster && pass.kind != PassKind::fullscreen) return {0, 0};
    if (pass.state.viewport) return {pass.state.viewport->width, pass.state.viewport->height};
    return {pass.render_extent.width, pass.render_extent.height};
}

Diagnostic too_few(const std::string& list, size_t given, size_t wanted) {
    return make_error("W193",
                      "the program gave " + std::to_string(given) + " views for the list \"" + list +
                          "\" in this frame, but the graph uses " + std::to_string(wanted),
                      {"set FrameInput::views to all views of the list in every frame"});
}

}  // namespace

std::string area_view(std::string_view view, const LiveArea& area) {
    return std::string(view) + " in " + std::to_string(area.image) + "." + std::to_string(area.mip);
}

void FrameViews::set_plan(const FramePlan& plan) {
    lists_ = plan.graph.views;
    std::map<std::string, glm::uvec2> used;
    std::set<ViewNames> united;
    for (const PassId id : plan.schedule.order) {
        const PassDecl& pass = plan.graph.passes[id];
        if (is_in_buffer(pass.view)) continue;
        // A debug view draws nothing from the view, so it must not change the view's size.
        const glm::uvec2 size_px = pass.name == kDebugView ? glm::uvec2(0) : size_of(pass);
        for (const std::string& view : pass.drawn_views()) {
            glm::uvec2& size = used[view];
            size = glm::max(size, size_px);
        }
        if (pass.lowering == ViewLowering::multiview) united.insert(pass.views);
    }
    used.erase(kCamera);
    united_views_.assign(united.begin(), united.end());
    views_.assign(1, {kCamera});
    sizes_px_.assign(1, {0, 0});
    for (const auto& [name, size] : used) {
        views_.push_back({name});
        sizes_px_.push_back(size);
    }
    ++plans_;
    has_fixed_ = false;
    for (FrameView& view : views_) view.fixed = is_fixed(view.name) ? plans_ : 0;
    add_area_views(plan);
}

// Adds the views for passes that draw only into an area of their image (an image with a live size). There is
// one view for each pair of a view and an area.
void FrameViews::add_area_views(const FramePlan& plan) {
    area_views_.clear();
    camera_area_ = {};
    std::set<std::string> known;
    for (const PassId id : plan.schedule.order) {
        const PassDecl& pass = plan.graph.passes[id];
        if (pass.area.image == kNoId || is_in_buffer(pass.view)) continue;
        const auto extent = [&](const LiveArea& area) {
            return mip_extent(plan.graph.resources[area.image].extent, area.mip).width;
        };
        const bool draws_camera = pass.kind == PassKind::raster && pass.view == kCamera;
        if (draws_camera && (camera_area_.image == kNoId || extent(pass.area) > extent(camera_area_)))
            camera_area_ = pass.area;
        if (!known.insert(area_view(pass.view, pass.area)).second) continue;
        const auto view = std::ranges::find(views_, pass.view, &FrameView::name);
        area_views_.push_back({static_cast<uint32_t>(view - views_.begin()), pass.area});
    }
    for (const AreaView& view : area_views_) views_.push_back({area_view(views_[view.view].name, view.area)});
}

void FrameViews::set_scales(const ResolvedGraph& graph, const Scales& scales) {
    evaluate_live(graph, scales, live_);
}

glm::uvec2 FrameViews::camera_px(const ResolvedGraph& graph, glm::uvec2 output_px) const {
    if (camera_area_.image == kNoId) return output_px;
    const Extent3D area = live_area(graph, camera_area_, live_);
    return {area.width, area.height};
}

bool FrameViews::is_fixed(const std::string& view) const {
    const auto list = std::ranges::find(lists_, parts_of(view).list, &ViewListDecl::name);
    if (list == lists_.end()) return false;
    return list->source == ViewSource::cube ||
           (list->source == ViewSource::program &&
            (list->name == kProbeFaceViews || list->name == kReflectionFaceViews));
}

bool FrameViews::is_in_buffer(const std::string& view) const {
    const auto list = std::ranges::find(lists_, parts_of(view).list, &ViewListDecl::name);
    return list != lists_.end() && list->source == ViewSource::buffer;
}

Status FrameViews::check(const ViewLists& program) const {
    for (const ViewListDecl& list : lists_) {
        if (list.source != ViewSource::program || list.name == kSun || list.name == kLampViews ||
            list.name == kFurtherSunViews || list.name == kSceneSunViews || list.name == kProbeFaceViews ||
            list.name == kReflectionFaceViews || list.name == kLampShadowViews)
            continue;
        const auto given = program.find(list.name);
        const size_t count = given != program.end() ? given->second.size() : 0;
        if (count < list.count) return too_few(list.name, count, list.count);
    }
    return Unit{};
}

void FrameViews::update(const ViewSources& sources, const ResolvedGraph& graph) {
    const Frame frame{sources, lamp_views(sources.lights)};
    std::map<std::string, glm::mat4> now;
    const size_t plain_views = views_.size() - area_views_.size();
    for (size_t i = 0; i < plain_views; ++i) {
        FrameView& view = views_[i];
        if (view.fixed != 0 && has_fixed_) continue;
        const ViewName name = parts_of(view.name);
        view.constants = make(frame, name.list, name.index);
        view.mirrored = is_mirrored(view.constants.view_projection);
        if (i == 0) continue;
        view.constants.number = name.index;
        if (sizes_px_[i].x > 0 && name.list != kSun) {
            view.constants.viewport_px = glm::vec2(sizes_px_[i]);
            view.constants.inverse_viewport = 1.0f / view.constants.viewport_px;
        }
        const glm::mat4& steady = view.constants.steady_view_projection;
        if (view.fixed != 0) {
            view.constants.prev_view_projection = steady;
            continue;
        }
        const auto before = before_.find(view.name);
        view.constants.prev_view_projection = before != before_.end() ? before->second : steady;
        now.emplace(view.name, steady);
    }
    before_ = std::move(now);
    has_fixed_ = true;
    for (size_t i = 0; i < area_views_.size(); ++i) {
        FrameView& view = views_[plain_views + i];
        const FrameView& plain = views_[area_views_[i].view];
        const Extent3D area = live_area(graph, area_views_[i].area, live_);
        view.constants = plain.constants;
        view.mirrored = plain.mirrored;
        view.constants.viewport_px = {area.width, area.height};
        view.constants.inverse_viewport = 1.0f / view.constants.viewport_px;
    }
}

shared::ViewConstants FrameViews::make(const Frame& frame, const std::string& name, uint32_t index) const {
    if (name == kCamera) return frame.sources.camera;
    const auto list = std::ranges::find(lists_, name, &ViewListDecl::name);
    switch (list->source) {
        case ViewSource::program:
            return make_given(frame, *list, index);
        case ViewSource::mirror:
            return mirrored(make(frame, list->of, list->first + index), list->plane);
        case ViewSource::cube:
        case ViewSource::buffer:  // update() never calls make() for a view in a buffer.
            break;
    }
    return constants_of(cube_face({list->at[0], list->at[1], list->at[2]}, index, list->near_m));
}

shared::ViewConstants FrameViews::make_given(const Frame& frame, const ViewListDecl& list,
                                             uint32_t index) const {
    if (list.name == kSun) return frame.sources.sun.views[std::min(index, shared::kMostSunCascades - 1u)];
    if (list.name == kFurtherSunViews)
        return frame.sources.further_suns.views[std::min(index, shared::kMostFurtherSuns - 1u)];
    if (list.name == kProbeFaceViews) return frame.sources.probe_faces[index];
    if (list.name == kReflectionFaceViews) return frame.sources.reflection_faces[index];
    if (list.name == kSceneSunViews)
        return frame.sources.further_suns.scene_views[std::min(index, shared::kMostSceneSuns - 1u)];
    if (list.name == kLampShadowViews) return frame.sources.lamp_shadows[index];
    if (list.name == kLampViews)
        // A lamp that has moved to a position outside the allowed range (scene::clamp_light()) gives no light
        // and has no views. Then `lamps` has fewer views than the plan uses.
        return index < frame.lamps.size() ? constants_of(frame.lamps[index]) : shared::ViewConstants{};
    return constants_of(frame.sources.program.find(list.name)->second[index]);
}

}  // namespace weft::render
