#include "graph/report/group_phrases.h"

#include <algorithm>

#include "graph/diagnostics/quantity_text.h"

namespace weft {
namespace {

bool is_limited(uint32_t rounds, const GroupDecl& group) {
    return rounds < group.rounds;
}

}  // namespace

const GroupDecl* group_of(const FramePlan& plan, PassId pass) {
    return find_group(plan.graph, plan.graph.passes[pass].rest_unit);
}

std::string describe_round(const FramePlan& plan, PassId pass) {
    const GroupDecl* group = group_of(plan, pass);
    if (group == nullptr) return {};
    return "round " + std::to_string(plan.graph.passes[pass].rest_unit - group->first_unit) + " of group \"" +
           group->name + "\"";
}

std::string describe_group(const GroupDecl& group) {
    std::string text = count_text(group.rounds, "round") + ", ";
    text += is_limited(group.per_frame, group) ? std::to_string(group.per_frame) : "all";
    text += " per frame";
    const bool warms_up = (is_limited(group.per_frame, group) && group.warm_up > group.per_frame) ||
                          (is_limited(group.warm_up, group) && !group.turns.empty());
    if (warms_up)
        text += ", " + (is_limited(group.warm_up, group) ? std::to_string(group.warm_up) : "all") +
                " per frame until all have run";
    if (!group.turns.empty()) text += ", turns from \"" + group.turns + "\"";
    if (group.rests) text += ", rest";
    if (group.settle > 0) text += ", settle " + std::to_string(group.settle);
    return text;
}

std::string describe_turns(const GroupDecl& group) {
    const bool limited = is_limited(group.per_frame, group);
    std::string text = "In each frame, ";
    text += !limited ? "all rounds of the group may run."
            : group.per_frame == 0
                ? "no round of the group may run."
                : "at most " + count_text(group.per_frame, "round") + " of the group may run.";
    if (!group.turns.empty())
        text += " The program lists the rounds in \"" + group.turns +
                "\", in the order in which they run. In a frame without a list, the rounds that have waited "
                "longest come first.";
    else if (limited && group.per_frame > 0)
        text += " The rounds that have waited longest come first.";
    const std::string warm_up =
        is_limited(group.warm_up, group) ? "up to " + std::to_string(group.warm_up) : "all of them";
    if (!group.turns.empty() && group.warm_up > 0)
        text +=
            " In addition, rounds that have never run come before the list: " + warm_up + " in each frame.";
    else if (limited && group.warm_up > group.per_frame)
        text += " Rounds that have not run yet come first: " + warm_up + " in each frame.";
    return text;
}

GroupBlock block_around(const FramePlan& plan, Position position) {
    if (position >= plan.schedule.order.size()) return {};
    const GroupDecl* group = group_of(plan, plan.schedule.order[position]);
    if (group == nullptr) return {};
    // In the schedule, the passes of a group directly follow one another.
    const auto is_member = [&](Position p) { return group_of(plan, plan.schedule.order[p]) == group; };
    GroupBlock block{position, position};
    while (block.first > 0 && is_member(Position(block.first - 1))) block.first = Position(block.first - 1);
    while (block.last + 1 < plan.schedule.order.size() && is_member(Position(block.last + 1)))
        block.last = Position(block.last + 1);
    return block;
}

}  // namespace weft
