#include "graph/rest/frame_steps.h"

#include <algorithm>

namespace weft {
std::vector<FrameStep> frame_steps(const FramePlan& plan, const Batch& batch,
                                   const std::vector<uint8_t>& runs, const std::vector<uint32_t>& rounds) {
    const auto unit_of = [&](Position position) {
        return plan.graph.passes[plan.schedule.order[position]].rest_unit;
    };
    std::vector<FrameStep> steps;
    for (size_t i = 0; i < batch.positions.size();) {
        const uint32_t unit = unit_of(batch.positions[i]);
        const GroupDecl* group = find_group(plan.graph, unit);
        if (group == nullptr) {
            steps.push_back({batch.positions[i++], true, unit == kNoId || runs[unit] != 0, true});
            continue;
        }
        // The positions of each round. All passes of a group are in one batch.
        std::vector<std::vector<Position>> places(group->rounds);
        const Position first = batch.positions[i];
        for (; i < batch.positions.size() && group->has_unit(unit_of(batch.positions[i])); ++i)
            places[unit_of(batch.positions[i]) - group->first_unit].push_back(batch.positions[i]);
        const Position last = batch.positions[i - 1];
        steps.push_back({first, true, false, false});
        for (const uint32_t round : rounds)
            if (group->has_unit(round))
                for (const Position position : places[round - group->first_unit])
                    steps.push_back({position, false, true, false});
        steps.push_back({last, false, false, true});
    }
    return steps;
}

}  // namespace weft
