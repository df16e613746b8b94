#include "check/structure/check_areas.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace weft::check {
namespace {

using Pair = std::array<double, 2>;

double operate(ExprOp op, double a, double b) {
    switch (op) {
        case ExprOp::add:
            return a + b;
        case ExprOp::sub:
            return a - b;
        case ExprOp::mul:
            return a * b;
        case ExprOp::div:
            return a / b;
        case ExprOp::mod:
            return a - std::floor(a / b) * b;
        case ExprOp::min:
            return std::fmin(a, b);
        case ExprOp::max:
            return std::fmax(a, b);
        case ExprOp::negate:
            return 0 - a;
        case ExprOp::ceil:
            return std::ceil(a);
        case ExprOp::floor:
            return std::floor(a);
        default:
            return std::log2(a);
    }
}

// Evaluates the live values of a plan (values that may change in each frame) with all scales set to 1. A
// value is empty if its expression cannot be evaluated.
class ValuesAtOne {
 public:
    explicit ValuesAtOne(const ResolvedGraph& graph) : graph_(graph) {
        for (const LiveValue& value : graph.live_values) values_.push_back(evaluate(value));
    }

    [[nodiscard]] std::optional<Pair> operator[](uint32_t index) const {
        return index < values_.size() ? values_[index] : std::nullopt;
    }
    // Returns the width (`side` 0) or height (`side` 1) of an area in pixels; 0 if the value is empty.
    [[nodiscard]] uint32_t side_px(uint32_t index, size_t side) const {
        const std::optional<Pair> value = (*this)[index];
        return value ? static_cast<uint32_t>(std::fmax(1, std::floor((*value)[side]))) : 0;
    }

 private:
    [[nodiscard]] std::optional<Pair> evaluate(const LiveValue& value) const {
        if (value.param != kNoId) {
            if (value.param >= graph_.params.size()) return std::nullopt;
            const bool scales = value.most != 0;
            if (scales && !(value.least > 0 && value.least <= value.most && value.most <= 1))
                return std::nullopt;
            const double number = scales ? 1 : graph_.params[value.param].value;
            return Pair{number, number};
        }
        std::optional<Pair> result = run(value.steps);
        if (!result || value.scale == kNoId) return result;
        const bool known = value.scale < values_.size() && graph_.live_values[value.scale].most != 0;
        if (!known) return std::nullopt;
        for (double& side : *result) side = std::fmax(1, std::floor(side));
        return result;
    }

    [[nodiscard]] std::optional<Pair> run(const std::vector<LiveStep>& steps) const {
        std::vector<Pair> stack;
        for (const LiveStep& step : steps) {
            if (step.op == ExprOp::number) {
                stack.push_back({step.number, step.number});
            } else if (step.op == ExprOp::name) {
                const std::optional<Pair> named = (*this)[step.value];
                if (!named) return std::nullopt;
                stack.push_back(*named);
            } else if (!combine(step.op, stack)) {
                return std::nullopt;
            }
        }
        return stack.size() == 1 ? std::optional(stack.front()) : std::nullopt;
    }

    static bool combine(ExprOp op, std::vector<Pair>& stack) {
        constexpr std::array kOfOne{ExprOp::select_x, ExprOp::select_y, ExprOp::negate,
                                    ExprOp::ceil,     ExprOp::floor,    ExprOp::log2};
        const size_t wanted = std::ranges::find(kOfOne, op) != kOfOne.end() ? 1 : 2;
        if (stack.size() < wanted || op == ExprOp::mips_of) return false;
        const Pair second = stack.back();
        if (wanted == 2) stack.pop_back();
        Pair& first = stack.back();
        if (op == ExprOp::select_x)
            first[1] = first[0];
        else if (op == ExprOp::select_y)
            first[0] = first[1];
        else if (op == ExprOp::make_size)
            first[1] = second[0];
        else
            first = {operate(op, first[0], second[0]), operate(op, first[1], second[1])};
        return true;
    }

    const ResolvedGraph& graph_;
    std::vector<std::optional<Pair>> values_;
};

class AreaCheck {
 public:
    AreaCheck(const FramePlan& plan, FaultList& faults)
        : graph_(plan.graph), faults_(faults), at_one_(plan.graph) {}

    void run() {
        for (const ResourceDecl& resource : graph_.resources) check_image(resource);
        for (const PassDecl& pass : graph_.passes) {
            check_attachments(pass);
            check_copy(pass);
            check_kept(pass);
            check_groups(pass);
            check_sides(pass);
            check_params(pass);
        }
    }

 private:
    // The area of a use: an index into live_values, and the mip.
    struct Area {
        uint32_t value = kNoId;
        uint32_t mip = 0;
        bool operator==(const Area&) const = default;
    };

    void fault(SourceLoc loc, const std::string& message) {
        faults_.add("C351", loc, message, "this is an error of Weft, not of the graph: please report it");
    }

    void check_image(const ResourceDecl& resource) {
        if (resource.ring != kNoId && graph_.resources[resource.ring].area != resource.area)
            return fault(resource.loc, "the copies of \"" + resource.name + "\" have different areas");
        if (resource.area == kNoId) return;
        if (resource.kind != ResourceKind::image || resource.lifetime == ResourceLifetime::imported)
            return fault(
                resource.loc,
                "\"" + resource.name + "\" has an area (a live size), but it is not an image of the graph");
        if (at_one_.side_px(resource.area, 0) != resource.extent.width ||
            at_one_.side_px(resource.area, 1) != resource.extent.height)
            fault(resource.loc,
                  "at scale 1, the area of \"" + resource.name + "\" differs from the extent of the image");
    }

    [[nodiscard]] Area area_of(const UseDecl& use) const {
        const uint32_t value = graph_.resources[use.resource].area;
        return value == kNoId ? Area{} : Area{value, use.range.mip};
    }

    [[nodiscard]] Area area_of(const PassDecl& pass) const {
        if (pass.area.image >= graph_.resources.size()) return {};
        return {graph_.resources[pass.area.image].area, pass.area.mip};
    }

    void check_attachments(const PassDecl& pass) {
        const auto check = [&](uint32_t use) {
            if (area_of(pass.uses[use]) != area_of(pass))
                fault(pass.loc, "pass \"" + pass.name + "\" has another area than its attachment \"" +
                                    pass.uses[use].port + "\"");
        };
        for (const AttachmentDecl& color : pass.colors) {
            check(color.use);
            if (color.resolve_use != kNoId) check(color.resolve_use);
        }
        if (pass.depth) check(pass.depth->use);
    }

    // If the area of an image changes and the image keeps its content, the whole image must be written again.
    // A rest unit is a set of passes that run only if an input has changed; a change of the area makes it
    // run, too. So only passes of rest units may write such an image.
    void check_kept(const PassDecl& pass) {
        for (const UseDecl& use : pass.uses) {
            const ResourceDecl& resource = graph_.resources[use.resource];
            const bool keeps = resource.lifetime == ResourceLifetime::persistent && resource.history == 0;
            if (use.is_output && keeps && resource.area != kNoId && pass.rest_unit == kNoId)
                fault(pass.loc,
                      "pass \"" + pass.name + "\" writes \"" + resource.name +
                          "\", which keeps its content between frames although its area may change");
        }
    }

    void check_copy(const PassDecl& pass) {
        if (pass.kind != PassKind::copy || pass.uses.size() != 2) return;
        if (area_of(pass.uses[0]) != area_of(pass.uses[1]))
            fault(pass.loc, "source and target of the copy \"" + pass.name + "\" have different areas");
    }

    void check_groups(const PassDecl& pass) {
        if (pass.live_groups.empty()) return;
        bool right = pass.live_groups.size() == 3 && pass.kind == PassKind::compute;
        for (size_t i = 0; right && i < 3; ++i) {
            const LiveCount& count = pass.live_groups[i];
            if (count.value == kNoId) continue;
            const std::optional<Pair> value = at_one_[count.value];
            right = value && count.side < 2 && count.per > 0;
            if (!right) break;
            double side = (*value)[count.side];
            if (count.mip != kNoId)
                side =
                    std::fmax(1, std::floor(at_one_.side_px(count.value, count.side) / std::exp2(count.mip)));
            right = std::ceil(side / count.per) == pass.groups[i];
        }
        if (!right)
            fault(pass.loc,
                  "at scale 1, pass \"" + pass.name + "\" has other numbers of workgroups than the plan");
    }

    void check_sides(const PassDecl& pass) {
        for (const LiveSide& side : pass.live_sides) {
            const std::optional<RectPx>& rect = side.scissor ? pass.state.scissor : pass.state.viewport;
            const std::optional<Pair> value = at_one_[side.value];
            bool right = rect && value && side.side < 4;
            if (right) {
                const std::array<double, 4> numbers{double(rect->x), double(rect->y), double(rect->width),
                                                    double(rect->height)};
                right = numbers[side.side] == std::floor((*value)[0]);
            }
            if (!right)
                fault(pass.loc,
                      "a rectangle of pass \"" + pass.name + "\" at scale 1 is not that of the plan");
        }
    }

    void check_params(const PassDecl& pass) {
        for (const ParamWrite& write : pass.params) {
            const bool of_port = write.builtin == Builtin::area_size || write.builtin == Builtin::area_uv ||
                                 write.builtin == Builtin::area_uv_most;
            bool right = true;
            if (of_port) right = write.use < pass.uses.size() && area_of(pass.uses[write.use]).value != kNoId;
            if (write.builtin == Builtin::live)
                right = write.live.size() == write.components &&
                        std::ranges::all_of(write.live, [&](uint32_t v) { return at_one_[v].has_value(); });
            if (!right)
                fault(pass.loc, "the member \"" + write.member + "\" of Params of pass \"" + pass.name +
                                    "\" must follow a live size, but its live values are unknown or do not "
                                    "match its components");
        }
    }

    const ResolvedGraph& graph_;
    FaultList& faults_;
    ValuesAtOne at_one_;
};

// A transfer queue may copy only whole mip levels.
void check_queues(const FramePlan& plan, FaultList& faults) {
    for (Position position(0); position < plan.schedule.order.size(); ++position) {
        const QueueIndex queue = plan.schedule.queue[position];
        if (plan.schedule.queues[queue].kind != QueueKind::transfer) continue;
        const PassDecl& pass = plan.graph.passes[plan.schedule.order[position]];
        for (const UseDecl& use : pass.uses)
            if (plan.graph.resources[use.resource].area != kNoId)
                faults.add("C351", pass.loc,
                           "pass \"" + pass.name + "\" copies the area of " +
                               faults.resource_name(use.resource) + " on a transfer queue",
                           "the pass must run on a queue that copies parts of images");
    }
}

}  // namespace

void check_areas(const FramePlan& plan, FaultList& faults) {
    AreaCheck(plan, faults).run();
    check_queues(plan, faults);
}

}  // namespace weft::check
