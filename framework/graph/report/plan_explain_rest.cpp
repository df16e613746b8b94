#include <algorithm>
#include <string>
#include <vector>

#include "graph/diagnostics/quantity_text.h"
#include "graph/report/group_phrases.h"
#include "graph/report/plan_phrases.h"
#include "graph/report/view_phrases.h"
#include "weft/report/plan_explain.h"

namespace weft {
namespace {

// A rest unit is a set of passes that run only if something has changed. This class collects all changes that
// make a rest unit run again. Each of them is one line of the answer.
class WakeReasons {
 public:
    explicit WakeReasons(const FramePlan& plan) : plan_(plan) {}

    void add(PassId id) {
        const PassDecl& pass = plan_.graph.passes[id];
        add_params(id);
        if (!pass.shader.empty()) {
            // If a buffer contains the view, this buffer is one of the uses of the pass. Then add_use() lists
            // the buffer, and no view is named here.
            const std::string view = pass.view_use == kNoId ? " and view \"" + view_range(pass) + "\"" : "";
            line("a constant of set 0 (frame" + view + ") that shader \"" + pass.shader +
                 "\" reads, if it reads one");
            line("shader \"" + pass.shader + "\" or one of its specialisation constants");
        }
        for (const std::string& list : pass.draw_lists) line("the objects of draw list \"" + list + "\"");
        for (const UseDecl& use : pass.uses) add_use(pass, use);
    }

    [[nodiscard]] std::string text() const {
        std::string all;
        for (const std::string& reason : lines_) all += "  " + reason + "\n";
        return all;
    }

 private:
    void line(const std::string& text) {
        if (std::ranges::find(lines_, text) == lines_.end()) lines_.push_back(text);
    }

    void add_params(PassId id) {
        for (const ParamWrite& param : plan_.graph.passes[id].params) {
            const bool always = param.builtin == Builtin::frame_index || param.builtin == Builtin::time_s ||
                                param.builtin == Builtin::delta_time_s;
            line("member \"" + param.member + "\" of Params of pass " + describe_pass(plan_, id) +
                 (always ? ", which changes in every frame" : ""));
        }
    }

    void add_use(const PassDecl& pass, const UseDecl& use) {
        if (!use.wakes) return;
        if (plan_.graph.resources[use.resource].import)
            line("the content of import " + describe_resource(plan_, use.resource));
        for (const VersionSource& source : use.sources) {
            if (source.producer == kNoId) continue;
            const PassDecl& maker = plan_.graph.passes[source.producer];
            if (maker.rest_unit != pass.rest_unit)
                line(describe_part(plan_, use.resource, source.range) + ", if pass " +
                     describe_pass(plan_, source.producer) + " runs");
        }
    }

    const FramePlan& plan_;
    std::vector<std::string> lines_;
};

// Returns the other live passes of the pass's rest unit, which always run together with the pass.
std::string other_passes(const FramePlan& plan, PassId id) {
    std::string others;
    for (PassId pass(0); pass < plan.graph.passes.size(); ++pass)
        if (pass != id && plan.live.live_passes[pass] &&
            plan.graph.passes[pass].rest_unit == plan.graph.passes[id].rest_unit)
            others += (others.empty() ? "" : ", ") + describe_pass(plan, pass);
    return others;
}

std::string wake_reasons(const FramePlan& plan, PassId id) {
    WakeReasons reasons(plan);
    for (PassId pass(0); pass < plan.graph.passes.size(); ++pass)
        if ((pass == id || plan.live.live_passes[pass]) &&
            plan.graph.passes[pass].rest_unit == plan.graph.passes[id].rest_unit)
            reasons.add(pass);
    return reasons.text();
}

std::string describe_round_rest(const FramePlan& plan, const GroupDecl& group, PassId id) {
    const std::string others = other_passes(plan, id);
    std::string text = "pass " + describe_pass(plan, id) + " belongs to " + describe_round(plan, id) + " (" +
                       describe_group(group) + ")" +
                       (others.empty() ? std::string() : " and runs only together with " + others) + ".\n  " +
                       describe_turns(group) + "\n";
    if (!group.rests)
        return text + "  The group has no \"rest\", so the round runs whenever it has its turn.\n";
    text += "  The group has \"rest\": the round runs only after a change";
    if (group.settle > 0) text += ", and then " + count_text(group.settle, "more time") + " (\"settle\")";
    return text +
           ". It runs once at the start, and after a change of its declaration, of the size of its "
           "resources, or "
           "of one of these:\n" +
           wake_reasons(plan, id);
}

std::string describe_rest(const FramePlan& plan, PassId id) {
    if (plan.graph.passes[id].rest_unit == kNoId)
        return "pass " + describe_pass(plan, id) +
               (plan.graph.passes[id].switch_id == kNoId ? " runs in every frame: it has no \"rest\"\n"
                                                         : " has no \"rest\", but a \"switch\"\n");
    if (const GroupDecl* group = group_of(plan, id)) return describe_round_rest(plan, *group, id);
    const std::string others = other_passes(plan, id);
    return "pass " + describe_pass(plan, id) + " rests" +
           (others.empty() ? std::string() : " and runs only together with " + others) +
           ". It runs in the first frame, and after a change of its declaration, of the size of its "
           "resources, or of one of these:\n" +
           wake_reasons(plan, id);
}

}  // namespace

Result<std::string> explain_rest(const FramePlan& plan, const std::string& name) {
    return describe_passes(plan, name, describe_rest);
}

}  // namespace weft
