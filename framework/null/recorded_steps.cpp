#include "null/recorded_steps.h"

#include <algorithm>

#include "null/cells.h"

namespace weft::null {
namespace {

// Returns the place of a round among the rounds that run in the frame, or UINT32_MAX if it does not run.
uint32_t turn_of(uint32_t unit, uint32_t frame, const RestChoice& resting, const RoundOrder& rounds) {
    if (frame >= rounds.size()) return rests(resting, unit, frame) ? UINT32_MAX : unit;
    const auto place = std::ranges::find(rounds[frame], unit);
    return place == rounds[frame].end() ? UINT32_MAX : static_cast<uint32_t>(place - rounds[frame].begin());
}

}  // namespace

std::vector<RecordedStep> recorded_steps(const FramePlan& plan, const Batch& batch, uint32_t frame,
                                         const RestChoice& resting, const RoundOrder& rounds) {
    const auto unit_at = [&](Position position) {
        return plan.graph.passes[plan.schedule.order[position]].rest_unit;
    };
    std::vector<RecordedStep> steps;
    for (const Position position : batch.positions)
        steps.push_back({position, true, !rests(resting, unit_at(position), frame), true});
    for (const GroupDecl& group : plan.graph.groups) {
        const auto is_member = [&](const RecordedStep& step) {
            return unit_at(step.position) != kNoId && group.has_unit(unit_at(step.position));
        };
        const auto begin = std::ranges::find_if(steps, is_member);
        if (begin == steps.end()) continue;
        const auto end = std::find_if_not(begin, steps.end(), is_member);
        const RecordedStep first{begin->position, true, false, false};
        const RecordedStep last{std::prev(end)->position, false, false, true};
        const auto turn = [&](const RecordedStep& step) {
            return turn_of(unit_at(step.position), frame, resting, rounds);
        };
        std::stable_sort(begin, end, [&](const auto& a, const auto& b) { return turn(a) < turn(b); });
        for (auto step = begin; step != end; ++step)
            *step = {step->position, false, turn(*step) != UINT32_MAX, false};
        const auto running = std::find_if(begin, end, [](const RecordedStep& step) { return !step.runs; });
        const auto place = steps.insert(steps.erase(running, end), last);
        steps.insert(place - (running - begin), first);
    }
    return steps;
}

}  // namespace weft::null
