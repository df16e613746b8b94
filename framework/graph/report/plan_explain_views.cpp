#include "graph/report/plan_phrases.h"
#include "graph/report/view_phrases.h"
#include "weft/report/plan_explain.h"

namespace weft {
namespace {

std::string describe_pass_views(const FramePlan& plan, PassId id) {
    const PassDecl& pass = plan.graph.passes[id];
    const std::string how = describe_lowering(pass);
    return "pass " + describe_pass(plan, id) + " draws " +
           (how.empty() ? "the view " + pass.view + ": it has no \"views\" in layers" : how) + "\n";
}

}  // namespace

Result<std::string> explain_views(const FramePlan& plan, const std::string& name) {
    return describe_passes(plan, name, describe_pass_views);
}

}  // namespace weft
