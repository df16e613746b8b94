// Answers the question `weft explain FILE switch PASS`: when is the pass switched off? What do readers of its
// outputs see then? Which inputs of the pass depend on switches?
#include <algorithm>

#include "graph/report/plan_phrases.h"
#include "graph/report/switch_phrases.h"
#include "weft/report/plan_explain.h"

namespace weft {
namespace {

// Tells what readers of an output see while the pass is off.
std::string describe_output(const FramePlan& plan, const UseDecl& use) {
    const std::string what = describe_part(plan, use.resource, use.range);
    std::string makers;
    for (const VersionSource& source : use.passes_on) {
        const std::string maker = source.producer == kNoId
                                      ? "of an earlier frame, or from before the frame"
                                      : "of pass " + describe_pass(plan, source.producer);
        if (makers.find(maker) == std::string::npos) makers += (makers.empty() ? "" : " and ") + maker;
    }
    if (makers.empty()) return "  While it is off, " + what + " has no content.\n";
    return "  While it is off, " + what + " keeps the content " + makers + ".\n";
}

std::string describe_input(const FramePlan& plan, const UseDecl& use) {
    return "  " + describe_use(plan, use) + " while " + describe_combinations(plan.graph, use.used_in) +
           ".\n";
}

std::string describe_switch(const FramePlan& plan, PassId id) {
    const PassDecl& pass = plan.graph.passes[id];
    std::string text = "pass " + describe_pass(plan, id);
    if (pass.switch_id == kNoId)
        text += " has no \"switch\"\n";
    else
        text += " runs while " + describe_combinations(plan.graph, pass.runs_in) +
                ". Its barriers are recorded in every frame.\n";
    for (const UseDecl& use : pass.uses)
        if (pass.switch_id != kNoId && writes(use.access)) text += describe_output(plan, use);
    for (const UseDecl& use : pass.uses)
        if (use.used_in != kEveryCombination) text += describe_input(plan, use);
    if (pass.variants.size() > 1)
        text += "  Its " + std::to_string(pass.variants.size()) +
                " variants, with different inputs or validities, are prepared with the plan.\n";
    return text;
}

}  // namespace

Result<std::string> explain_switch(const FramePlan& plan, const std::string& name) {
    return describe_passes(plan, name, describe_switch);
}

}  // namespace weft
