#include "check/structure/check_switches.h"

#include <algorithm>

namespace weft::check {
namespace {

constexpr const char* kSwitchHelp = "this is an error of Weft, not of the graph: please report it";

// Checks one pass of a graph with switches.
class SwitchedPass {
 public:
    SwitchedPass(const ResolvedGraph& graph, PassId id, FaultList& faults)
        : graph_(graph), pass_(graph.passes[id]), id_(id), faults_(faults) {}

    void check() {
        check_switch();
        check_variants();
        for (size_t i = 0; i < pass_.uses.size(); ++i) check_use(i);
    }

 private:
    void fault(SourceLoc loc, const std::string& what) {
        faults_.add("C349", loc, "pass " + faults_.pass_name(id_) + " " + what, kSwitchHelp);
    }

    void check_switch() {
        if (pass_.switch_id == kNoId) {
            if (pass_.runs_in != kEveryCombination)
                fault(pass_.loc, "has no switch, but does not run in all combinations of the switches");
            return;
        }
        CombinationSet on = 0;
        for (Combination c = 0; c < kCombinationCount; ++c)
            if ((c >> pass_.switch_id & 1u) != 0) on = static_cast<CombinationSet>(on | 1u << c);
        const auto off = static_cast<CombinationSet>(~on);
        if (pass_.switch_id >= graph_.switches.size() || (pass_.runs_in != on && pass_.runs_in != off))
            fault(pass_.loc, "runs in other frames than its switch says");
        if (pass_.rest_unit != kNoId || pass_.frame_slices != 0)
            fault(pass_.loc, "has a switch, but it is also a pass with rest, perFrame or a group");
    }

    void check_variants() {
        if (pass_.variants.empty()) return;
        uint32_t seen = 0;
        for (const PassVariant& variant : pass_.variants) {
            if ((seen & variant.combinations) != 0)
                fault(pass_.loc, "has two variants for one combination of the switches");
            seen |= variant.combinations;
        }
        if (seen != kEveryCombination) fault(pass_.loc, "lacks a variant for a combination of the switches");
    }

    void check_use(size_t index) {
        const UseDecl& use = pass_.uses[index];
        if (!use.passes_on.empty() && (pass_.switch_id == kNoId || !writes(use.access)))
            fault(use.loc, "passes on an earlier version of " + faults_.resource_name(use.resource) +
                               " for frames in which it does not write, but it has no switch or does not "
                               "write this resource");
        if (use.used_in == kEveryCombination) return;
        if (writes(use.access) || pass_.variants.empty())
            fault(use.loc, "uses " + faults_.resource_name(use.resource) +
                               " only in some combinations of the switches, but writes the resource or has "
                               "no variants for these combinations");
        // The constants of a variant hold for a set of combinations of switches. In all of these combinations
        // in which the pass runs, the pass must use the same resources.
        for (const PassVariant& variant : pass_.variants) {
            const uint32_t runs = variant.combinations & pass_.runs_in;
            if ((runs & use.used_in) != 0 && (runs & ~use.used_in) != 0)
                fault(use.loc, "has a variant that uses " + faults_.resource_name(use.resource) +
                                   " only in some of its combinations of the switches");
        }
        for (size_t other = index + 1; other < pass_.uses.size(); ++other)
            if (pass_.uses[other].port == use.port && pass_.uses[other].is_output == use.is_output &&
                (pass_.uses[other].used_in & use.used_in) != 0)
                fault(use.loc, "has two resources for the port \"" + use.port +
                                   "\" in one combination of the switches");
    }

    const ResolvedGraph& graph_;
    const PassDecl& pass_;
    PassId id_;
    FaultList& faults_;
};

}  // namespace

void check_switches(const FramePlan& plan, FaultList& faults) {
    if (plan.graph.switches.size() > kMostSwitches)
        faults.add("C349", {}, "the graph has " + std::to_string(plan.graph.switches.size()) + " switches",
                   kSwitchHelp);
    for (PassId id(0); id < plan.graph.passes.size(); ++id) SwitchedPass(plan.graph, id, faults).check();
}

}  // namespace weft::check
