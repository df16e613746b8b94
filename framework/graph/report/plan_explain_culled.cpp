#include <algorithm>
#include <vector>

#include "graph/report/plan_phrases.h"
#include "weft/report/plan_explain.h"

namespace weft {
namespace {

// A need for the result of one pass (the argument of needs_of()). The pass `reader` reads this result with
// its use `use`, either in the same frame or in a later frame.
struct Need {
    PassId reader = kNoId;
    const UseDecl* use = nullptr;
};

bool writes_ring(const FramePlan& plan, PassId pass, ResourceId ring) {
    const std::vector<UseDecl>& uses = plan.graph.passes[pass].uses;
    return ring != kNoId && std::any_of(uses.begin(), uses.end(), [&](const UseDecl& use) {
               return writes(use.access) && plan.graph.resources[use.resource].ring == ring;
           });
}

// Returns true if `pass` may have written one of `versions`. `versions` is a list of versions that `use`
// reads or passes on.
bool contains_result(const FramePlan& plan, const UseDecl& use, const std::vector<VersionSource>& versions,
                     PassId pass) {
    const ResourceId ring = plan.graph.resources[use.resource].ring;
    return std::any_of(versions.begin(), versions.end(), [&](const VersionSource& source) {
        return source.producer == kNoId ? writes_ring(plan, pass, ring) : source.producer == pass;
    });
}

bool sees(const FramePlan& plan, const UseDecl& use, PassId pass) {
    return contains_result(plan, use, use.sources, pass) || contains_result(plan, use, use.passes_on, pass);
}

std::vector<Need> needs_of(const FramePlan& plan, PassId pass) {
    std::vector<Need> needs;
    for (PassId reader(0); reader < plan.graph.passes.size(); ++reader) {
        if (reader == pass) continue;
        for (const UseDecl& use : plan.graph.passes[reader].uses)
            if (sees(plan, use, pass)) needs.push_back({reader, &use});
    }
    return needs;
}

const UseDecl* output_write(const FramePlan& plan, PassId pass) {
    if (plan.graph.output == kNoId) return nullptr;
    for (const UseDecl& use : plan.graph.passes[pass].uses)
        if (use.resource == plan.graph.output && writes(use.access)) return &use;
    return nullptr;
}

const UseDecl* export_write(const FramePlan& plan, PassId pass) {
    for (const UseDecl& use : plan.graph.passes[pass].uses)
        if (plan.graph.resources[use.resource].between && writes(use.access)) return &use;
    return nullptr;
}

std::string describe_root(const FramePlan& plan, PassId pass) {
    if (const UseDecl* use = output_write(plan, pass)) return describe_use(plan, *use) + ", the output";
    if (const UseDecl* use = export_write(plan, pass))
        return describe_use(plan, *use) + ", which the program reads between frames";
    return plan.graph.passes[pass].side_effect ? "the pass has a side effect, so it always runs" : "";
}

// Returns one chain of readers that explains why `pass`, a live pass, is not culled. The chain ends at a pass
// that must run because it writes the output or has a side effect.
std::vector<Need> way_to_root(const FramePlan& plan, PassId pass) {
    std::vector<Need> way;
    std::vector<uint8_t> seen(plan.graph.passes.size(), 0);
    while (describe_root(plan, pass).empty()) {
        seen[pass] = 1;
        const std::vector<Need> needs = needs_of(plan, pass);
        const auto next = std::find_if(needs.begin(), needs.end(), [&](const Need& need) {
            return plan.live.live_passes[need.reader] && !seen[need.reader];
        });
        if (next == needs.end()) break;
        way.push_back(*next);
        pass = next->reader;
    }
    return way;
}

std::string describe_live_pass(const FramePlan& plan, PassId pass) {
    std::string text = describe_pass(plan, pass) + " is not culled: the pass runs at position " +
                       std::to_string(plan.schedule.position[pass]) + ".\n";
    if (const std::string root = describe_root(plan, pass); !root.empty()) text += "  " + root + ".\n";
    for (const Need& need : needs_of(plan, pass))
        if (plan.live.live_passes[need.reader])
            text += "  " + describe_pass(plan, need.reader) +
                    (contains_result(plan, *need.use, need.use->sources, pass)
                         ? " needs its result: "
                         : " hands on its result while it is switched off: ") +
                    describe_use(plan, *need.use) + ".\n";
    const std::vector<Need> way = way_to_root(plan, pass);
    if (way.empty()) return text;
    const PassId end = way.back().reader;
    text += "  The chain of readers ends at " + describe_pass(plan, end) + ": " + describe_root(plan, end) +
            ".\n";
    return text;
}

std::string describe_culled_pass(const FramePlan& plan, PassId pass) {
    std::string text = describe_pass(plan, pass) + " is culled: " + plan.live.details[pass] + ".\n";
    for (const UseDecl& use : plan.graph.passes[pass].uses)
        if (writes(use.access)) text += "  " + describe_use(plan, use) + ".\n";
    for (const Need& need : needs_of(plan, pass))
        text += "  " + describe_pass(plan, need.reader) +
                " would read its result, but is culled too: " + plan.live.details[need.reader] + ".\n";
    return text;
}

std::string describe_live_or_culled(const FramePlan& plan, PassId pass) {
    return plan.live.live_passes[pass] ? describe_live_pass(plan, pass) : describe_culled_pass(plan, pass);
}

}  // namespace

Result<std::string> explain_culled(const FramePlan& plan, const std::string& name) {
    return describe_passes(plan, name, describe_live_or_culled);
}

}  // namespace weft
