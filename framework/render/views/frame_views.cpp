#include "render/views/frame_views.h"

#include <algorithm>
#include <set>

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
    Diagnostic d;
    d.code = "W193";
    d.message = "the program gave " + std::to_string(given) + " views for the list \"" + list +
                "\" in this frame, but the graph uses " + std::to_string(wanted);
    d.help = {"set FrameInput::views to all views of the list in every frame"};
    return d;
}

}  // namespace

void FrameViews::set_plan(const FramePlan& plan) {
    lists_ = plan.graph.views;
    std::map<std::string, glm::uvec2> used;
    std::set<ViewNames> united;
    for (const PassId id : plan.schedule.order) {
        const PassDecl& pass = plan.graph.passes[id];
        for (const std::string& view : pass.drawn_views()) {
            glm::uvec2& size = used[view];
            size = glm::max(size, size_of(pass));
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
}

Status FrameViews::check(const ViewLists& program) const {
    for (const ViewListDecl& list : lists_) {
        if (list.source != ViewSource::program || list.name == kSun || list.name == kLampViews) continue;
        const auto given = program.find(list.name);
        const size_t count = given != program.end() ? given->second.size() : 0;
        if (count < list.count) return too_few(list.name, count, list.count);
    }
    return Unit{};
}

void FrameViews::update(const ViewSources& sources) {
    const Frame frame{sources, lamp_views(sources.lights)};
    std::map<std::string, glm::mat4> now;
    for (size_t i = 0; i < views_.size(); ++i) {
        FrameView& view = views_[i];
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
        const auto before = before_.find(view.name);
        view.constants.prev_view_projection = before != before_.end() ? before->second : steady;
        now.emplace(view.name, steady);
    }
    before_ = std::move(now);
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
            break;
    }
    return constants_of(cube_face({list->at[0], list->at[1], list->at[2]}, index, list->near_m));
}

shared::ViewConstants FrameViews::make_given(const Frame& frame, const ViewListDecl& list,
                                             uint32_t index) const {
    if (list.name == kSun) return frame.sources.sun.views[std::min(index, shared::kMostSunCascades - 1u)];
    if (list.name == kLampViews)
        // A lamp that has moved too far away gives no light and no views.
        return index < frame.lamps.size() ? constants_of(frame.lamps[index]) : shared::ViewConstants{};
    return constants_of(frame.sources.program.find(list.name)->second[index]);
}

}  // namespace weft::render
