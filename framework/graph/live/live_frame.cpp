#include "graph/live/live_frame.h"

#include <algorithm>
#include <cmath>

#include "graph/model/expr_op.h"

namespace weft {
namespace {

// The largest number of workgroups in one dimension that every Vulkan device supports.
constexpr double kMostGroups = 65535;
// The product of a size and a scale may be above a whole number because of rounding errors, for example
// 0.1 * 30. Such a difference must not add a pixel.
constexpr double kTolerance_px = 1.0 / 1024;
// Most expressions need a stack of at most this depth.
constexpr size_t kUsualDepth = 16;

double finite(double x) {
    return std::isfinite(x) ? x : 0;
}

uint32_t whole(double x, double least, double most) {
    return static_cast<uint32_t>(std::clamp(finite(x), least, most));
}

LiveNumber apply(ExprOp op, const LiveNumber& a, const LiveNumber& b) {
    if (op == ExprOp::select_x) return {a.x, a.x};
    if (op == ExprOp::select_y) return {a.y, a.y};
    if (op == ExprOp::make_size) return {a.x, b.x};
    return {finite(apply_op(op, a.x, b.x)), finite(apply_op(op, a.y, b.y))};
}

LiveNumber run_steps(const std::vector<LiveStep>& steps, std::span<const LiveNumber> values,
                     std::vector<LiveNumber>& stack) {
    stack.clear();
    for (const LiveStep& step : steps) {
        if (step.op == ExprOp::number) {
            stack.push_back({step.number, step.number});
            continue;
        }
        if (step.op == ExprOp::name) {
            stack.push_back(values[step.value]);
            continue;
        }
        LiveNumber second;
        if (is_binary(step.op)) {
            second = stack.back();
            stack.pop_back();
        }
        stack.back() = apply(step.op, stack.back(), second);
    }
    return stack.back();
}

double param_value(const ResolvedGraph& graph, const LiveValue& value, const Scales& scales) {
    const GraphParam& param = graph.params[value.param];
    if (value.most == 0) return param.value;
    const auto given = scales.find(param.name);
    const double scale = given != scales.end() ? given->second : param.value;
    return std::isnan(scale) ? value.most : std::clamp(scale, value.least, value.most);
}

// Returns the width or height of a live size (a size that changes with a scale): `side_px`, the side of the
// allocated image, times the scale, rounded up; at least 1 and at most `side_px`.
double scaled(double side_px, double scale) {
    const double most = std::max(1.0, std::floor(side_px));
    return std::clamp(std::ceil(side_px * scale - kTolerance_px), 1.0, most);
}

double side_of(const LiveCount& count, std::span<const LiveNumber> values) {
    const LiveNumber& value = values[count.value];
    const double side = count.side == 0 ? value.x : value.y;
    if (count.mip == kNoId) return side;
    const uint32_t first = whole(std::floor(side), 1, UINT32_MAX);
    return std::max(1u, first >> count.mip);
}

void set_side(RectPx& rect, uint32_t side, double value) {
    const double number = std::floor(finite(value));
    if (side == 0) rect.x = static_cast<int32_t>(std::clamp(number, -1.0 * (1 << 30), 1.0 * (1 << 30)));
    if (side == 1) rect.y = static_cast<int32_t>(std::clamp(number, -1.0 * (1 << 30), 1.0 * (1 << 30)));
    if (side == 2) rect.width = whole(number, 1, 1 << 30);
    if (side == 3) rect.height = whole(number, 1, 1 << 30);
}

}  // namespace

void evaluate_live(const ResolvedGraph& graph, const Scales& scales, std::vector<LiveNumber>& values) {
    values.clear();
    if (graph.live_values.empty()) return;
    std::vector<LiveNumber> stack;
    stack.reserve(kUsualDepth);
    for (const LiveValue& value : graph.live_values) {
        if (value.param != kNoId) {
            const double number = param_value(graph, value, scales);
            values.push_back({number, number});
            continue;
        }
        LiveNumber number = run_steps(value.steps, values, stack);
        if (value.scale != kNoId) {
            const double scale = values[value.scale].x;
            number = {scaled(number.x, scale), scaled(number.y, scale)};
        }
        values.push_back(number);
    }
}

Extent3D live_area(const ResourceDecl& image, std::span<const LiveNumber> values) {
    if (image.area == kNoId) return image.extent;
    const LiveNumber& value = values[image.area];
    return {whole(std::floor(value.x), 1, image.extent.width),
            whole(std::floor(value.y), 1, image.extent.height), image.extent.depth};
}

Extent3D live_area(const ResolvedGraph& graph, const LiveArea& area, std::span<const LiveNumber> values) {
    return mip_extent(live_area(graph.resources[area.image], values), area.mip);
}

std::array<uint32_t, 3> live_groups(const PassDecl& pass, std::span<const LiveNumber> values) {
    std::array<uint32_t, 3> groups = pass.groups;
    for (size_t i = 0; i < pass.live_groups.size(); ++i) {
        const LiveCount& count = pass.live_groups[i];
        if (count.value != kNoId)
            groups[i] = whole(std::ceil(side_of(count, values) / count.per), 1, kMostGroups);
    }
    return groups;
}

RasterState live_state(const PassDecl& pass, std::span<const LiveNumber> values) {
    RasterState state = pass.state;
    for (const LiveSide& side : pass.live_sides) {
        std::optional<RectPx>& rect = side.scissor ? state.scissor : state.viewport;
        if (rect) set_side(*rect, side.side, values[side.value].x);
    }
    if (state.scissor) {
        state.scissor->x = std::max(0, state.scissor->x);
        state.scissor->y = std::max(0, state.scissor->y);
    }
    return state;
}

}  // namespace weft
