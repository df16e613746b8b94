#include "graph/report/switch_phrases.h"

#include "graph/resolve/switches/switches_text.h"

namespace weft {

std::string describe_combinations(const ResolvedGraph& graph, CombinationSet set) {
    // Each iteration selects some combinations of the set, appends a text about these combinations, and
    // removes these combinations from the set.
    std::string all;
    while (set != 0 && set != kEveryCombination) {
        const SwitchValues values = fewest_values(graph.switches, set);
        all += (all.empty() ? "" : ", or ") + values_text(graph.switches, values);
        set = static_cast<CombinationSet>(set & complement(values.combinations()));
    }
    return all;
}

std::string switched_passes(const FramePlan& plan, uint32_t switch_id) {
    std::string names;
    for (const PassId id : plan.schedule.order) {
        const PassDecl& pass = plan.graph.passes[id];
        if (pass.switch_id != switch_id) continue;
        names += (names.empty() ? "" : ", ") +
                 std::string(has_combination(pass.runs_in, kAllSwitchesOn) ? "" : "!") + pass.name;
    }
    return names;
}

}  // namespace weft
