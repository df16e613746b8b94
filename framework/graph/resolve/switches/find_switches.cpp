#include "graph/resolve/switches/find_switches.h"

#include <algorithm>

#include "graph/resolve/fault_text.h"
#include "graph/resolve/pass_ports.h"

namespace weft {
namespace {

// Reports a pass with "switch" that belongs to a group, or that also has the key "rest" or "perFrame".
void check_switch_keys(PassId id, const PassDraft& draft, PassReporter& report) {
    const PassDesc& desc = *draft.desc;
    const bool sliced = !desc.per_frame.empty() && desc.per_frame.text != "false";
    const char* other = !desc.group.empty() ? nullptr : desc.rests ? "rest" : sliced ? "perFrame" : "";
    if (other != nullptr && *other == '\0') return;
    const std::string who = "pass " + quote(desc.name);
    Diagnostic& d = report.error(
        id, desc.switch_loc, "W235",
        other == nullptr ? who + " belongs to group " + quote(desc.group) + ", so it cannot have \"switch\""
                         : who + " has both \"switch\" and " + quote(other));
    if (other == nullptr)
        add_help(d, "move the pass out of the group, or remove \"switch\"");
    else
        add_help(d, "remove one of the two keys");
    add_help(d, "or use \"if\": " + quote(desc.switch_param) +
                    " instead of \"switch\". Then Weft makes a new plan when the parameter changes");
}

// Warns about a pass whose "if" depends on the parameter of its "switch": a change of the parameter makes a
// new plan, so the switch saves nothing.
void warn_of_condition(const PassDesc& desc, Reporter& reporter) {
    const bool named = std::ranges::any_of(desc.condition.postfix, [&](const ExprNode& node) {
        return node.op == ExprOp::name && node.name == desc.switch_param;
    });
    if (!named) return;
    reporter.warn(
        desc.switch_loc, "W235",
        "pass " + quote(desc.name) + " has both \"switch\" and \"if\" with the parameter " +
            quote(desc.switch_param) + ", so a change of this parameter makes a new plan",
        "remove \"if\", so that the switch turns the pass off without a new plan; or remove \"switch\"");
}

// Returns true if the name is a parameter. Otherwise reports an error.
bool check_is_param(const ResolveInput& input, PassId id, const PassDesc& desc, PassReporter& report) {
    if (input.graph.params.contains(desc.switch_param)) return true;
    std::vector<std::string> known;
    for (const auto& [name, unused] : input.graph.params) known.push_back(name);
    Diagnostic& d = report.error(id, desc.switch_loc, "W233",
                                 "the switch of pass " + quote(desc.name) + " is " +
                                     quote(desc.switch_param) + ", which is not a parameter of the graph");
    const std::string near = did_you_mean_text(desc.switch_param, known);
    add_help(d, near.empty() ? "declare it: \"params\": { " + quote(desc.switch_param) + ": true }" : near);
    return false;
}

// Adds the parameter to the switches, unless the graph has too many of them.
bool add_switch(PassId id, const PassDesc& desc, std::vector<SwitchDecl>& switches, PassReporter& report) {
    const auto place = std::ranges::lower_bound(switches, desc.switch_param, {}, &SwitchDecl::param);
    if (place != switches.end() && place->param == desc.switch_param) return true;
    if (switches.size() < kMostSwitches) {
        switches.insert(place, {desc.switch_param});
        return true;
    }
    std::string known;
    for (const SwitchDecl& other : switches) known += (known.empty() ? "" : ", ") + quote(other.param);
    Diagnostic& d = report.error(id, desc.switch_loc, "W233",
                                 quote(desc.switch_param) + " is one switch too many: a graph has at most " +
                                     std::to_string(kMostSwitches) + ", and this one already has " + known);
    add_help(d, "let several passes use the same switch");
    add_help(d, "or use \"if\": " + quote(desc.switch_param) +
                    " instead of \"switch\". Then Weft makes a new plan when the parameter changes");
    return false;
}

// Observers (passes that read a resource back) and debug views only look at a resource. If all passes that
// write the resource have the same switch, the looking pass gets this switch too: while the resource is
// absent, there is nothing to see.
void follow_switch(const ResolveInput& input, Expansion& expansion, PassDraft& looking) {
    const std::string& shown = looking.desc->in.front().ref.name;
    const auto resource = input.graph.resources.find(shown);
    if (resource != input.graph.resources.end() && resource->second.keep != KeepMode::none) return;
    const PassDecl* like = nullptr;
    for (const PassDraft& other : expansion.passes) {
        if (&other == &looking || !output_of(*other.desc, shown)) continue;
        if (other.decl.switch_id == kNoId || (like != nullptr && like->runs_in != other.decl.runs_in)) return;
        like = &other.decl;
    }
    if (like == nullptr) return;
    looking.decl.switch_id = like->switch_id;
    looking.decl.runs_in = like->runs_in;
}

}  // namespace

void find_switches(const ResolveInput& input, Expansion& expansion, PassReporter& report,
                   Reporter& reporter) {
    // This loop visits the descriptions in the graph file, because a pass that its "if" removes is not among
    // the passes of the expansion.
    for (const auto& [name, desc] : input.graph.passes)
        if (!desc.switch_param.empty()) warn_of_condition(desc, reporter);
    for (PassId id(0); id < expansion.passes.size(); ++id) {
        const PassDesc& desc = *expansion.passes[id].desc;
        if (desc.switch_param.empty() || expansion.passes[id].instance > 0) continue;
        check_switch_keys(id, expansion.passes[id], report);
        if (check_is_param(input, id, desc, report)) add_switch(id, desc, expansion.switches, report);
    }
    if (expansion.switches.empty()) return;
    for (PassDraft& draft : expansion.passes) {
        const auto found =
            std::ranges::find(expansion.switches, draft.desc->switch_param, &SwitchDecl::param);
        if (found == expansion.switches.end()) continue;
        draft.decl.switch_id = static_cast<uint32_t>(found - expansion.switches.begin());
        const CombinationSet on = combinations_with(draft.decl.switch_id);
        draft.decl.runs_in = draft.desc->switch_inverted ? complement(on) : on;
    }
    for (const bool observers : {false, true})
        for (PassDraft& draft : expansion.passes)
            if (observers ? draft.is_observer : draft.desc->observes) follow_switch(input, expansion, draft);
}

}  // namespace weft
