#include "tests/null/rest_closure.h"

#include <map>

namespace weft::test {

RestChoice rest_closure(const FramePlan& plan, const InputChoice& inputs) {
    const uint32_t count = plan.graph.rest_unit_count;
    std::vector<std::map<PassId, uint32_t>> last_inputs(count);
    std::map<PassId, uint32_t> runs;  // Number of runs of each pass so far.
    std::vector<std::map<std::pair<PassId, PassId>, uint32_t>> last_seen(count);
    RestChoice resting;
    for (const std::vector<uint32_t>& frame : inputs) {
        std::vector<uint8_t> awake(count, 0);
        const std::map<PassId, uint32_t> before = runs;
        std::vector<std::map<PassId, uint32_t>> now_inputs(count);
        std::vector<std::map<std::pair<PassId, PassId>, uint32_t>> seen(count);
        // A unit that wakes late may wake a unit whose first passes were already visited. So the frame is
        // repeated until nothing changes.
        for (std::vector<uint8_t> old{2}; old != awake;) {
            old = awake;
            runs = before;
            for (const PassId id : plan.schedule.order) {
                const PassDecl& pass = plan.graph.passes[id];
                if (pass.rest_unit == kNoId) continue;
                now_inputs[pass.rest_unit][id] = frame[id];
                for (const UseDecl& use : pass.uses)
                    for (const VersionSource& source : use.sources)
                        if (source.producer != kNoId &&
                            plan.graph.passes[source.producer].rest_unit != pass.rest_unit)
                            seen[pass.rest_unit][{id, source.producer}] = runs[source.producer];
                if (awake[pass.rest_unit]) ++runs[id];
            }
            for (uint32_t unit = 0; unit < count; ++unit)
                if (now_inputs[unit] != last_inputs[unit] || seen[unit] != last_seen[unit]) awake[unit] = 1;
        }
        resting.emplace_back();
        for (uint32_t unit = 0; unit < count; ++unit) {
            resting.back().push_back(awake[unit] ? 0 : 1);
            if (awake[unit]) last_inputs[unit] = now_inputs[unit], last_seen[unit] = seen[unit];
        }
    }
    return resting;
}

}  // namespace weft::test
