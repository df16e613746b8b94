#include "graph/report/plan_phrases.h"

#include <algorithm>

namespace weft {
namespace {

std::string quoted(const std::string& name) {
    return "\"" + name + "\"";
}

std::string place(const FramePlan& plan, const SourceLoc& loc) {
    return loc.file < plan.graph.sources.files.size() ? " (" + plan.graph.sources.describe(loc) + ")" : "";
}

// Returns the ids of all items that a `repeat` made from the item `name`: "name#1", "name#2" and so on.
template <class Index, class T>
std::vector<Index> rounds_of(const std::vector<T>& items, const std::string& name) {
    std::vector<Index> rounds;
    for (Index id(0); id < items.size(); ++id)
        if (items[id].name.starts_with(name + "#")) rounds.push_back(id);
    return rounds;
}

template <class Index, class T>
std::string name_one_of(const std::vector<T>& items, const std::vector<Index>& rounds) {
    constexpr size_t kMost = 8;
    std::string text;
    for (size_t i = 0; i < std::min(rounds.size(), kMost); ++i)
        text += (i > 0 ? ", " : "") + quoted(items[rounds[i]].name);
    if (rounds.size() > kMost) text += " … " + quoted(items[rounds.back()].name);
    return "this name has several iterations: write one of " + text;
}

template <class Index, class T>
Result<Index> find_named(const FramePlan& plan, const std::vector<T>& items, Index found,
                         const std::string& name, const char* what, const char* code) {
    if (found != kNoId) return found;
    std::vector<std::string> known;
    for (const T& item : items) known.push_back(item.name);
    Diagnostic d;
    d.code = code;
    d.file = plan.graph.sources.files.empty() ? "" : plan.graph.sources.files.front().path;
    d.message = "the plan has no " + std::string(what) + " \"" + name + "\"";
    if (const std::vector<Index> rounds = rounds_of<Index>(items, name); !rounds.empty()) {
        d.help = {name_one_of(items, rounds)};
        return d;
    }
    const std::string guess = did_you_mean_text(name, known);
    d.help = {guess.empty() ? "run `weft plan` for a list of all names" : guess};
    return d;
}

// Returns `one` if it is an id, or the ids of all iterations with this name, or the error of `one`.
template <class Index, class T>
Result<std::vector<Index>> one_or_rounds(Result<Index> one, const std::vector<T>& items,
                                         const std::string& name) {
    if (one) return std::vector<Index>{*one};
    if (std::vector<Index> rounds = rounds_of<Index>(items, name); !rounds.empty()) return rounds;
    return one.take_errors();
}

}  // namespace

std::string describe_pass(const FramePlan& plan, PassId pass) {
    return quoted(plan.graph.passes[pass].name) + place(plan, plan.graph.passes[pass].loc);
}

std::string describe_resource(const FramePlan& plan, ResourceId resource) {
    return quoted(plan.graph.resources[resource].name) + place(plan, plan.graph.resources[resource].loc);
}

std::string describe_part(const FramePlan& plan, ResourceId resource, const SubresourceRange& range) {
    const ResourceDecl& decl = plan.graph.resources[resource];
    return quoted(decl.name + (range == decl.whole() ? "" : range_text(decl, range)));
}

const char* access_verb(Access access) {
    return !writes(access) ? "reads" : reads(access) ? "reads and writes" : "writes";
}

std::string describe_use(const FramePlan& plan, const UseDecl& use) {
    return "port " + quoted(use.port) + place(plan, use.loc) + " " + access_verb(use.access) + " " +
           describe_part(plan, use.resource, use.range);
}

std::string describe_position(const FramePlan& plan, Position position) {
    if (position >= plan.schedule.order.size()) return "the end of the frame";
    return std::to_string(position) + " " + quoted(plan.graph.passes[plan.schedule.order[position]].name);
}

std::string describe_state(const AccessState& state, bool image) {
    std::string text = stages_text(state.stages) + " " + access_text(state.access);
    if (image) text += " " + layout_text(state.layout);
    return text;
}

Result<PassId> named_pass(const FramePlan& plan, const std::string& name) {
    return find_named(plan, plan.graph.passes, find_pass(plan.graph, name), name, "pass", "W104");
}

Result<ResourceId> named_resource(const FramePlan& plan, const std::string& name) {
    return find_named(plan, plan.graph.resources, find_resource(plan.graph, name), name, "resource", "W103");
}

Result<std::vector<PassId>> named_passes(const FramePlan& plan, const std::string& name) {
    return one_or_rounds(named_pass(plan, name), plan.graph.passes, name);
}

Result<std::vector<ResourceId>> named_resources(const FramePlan& plan, const std::string& name) {
    return one_or_rounds(named_resource(plan, name), plan.graph.resources, name);
}

Result<std::string> describe_passes(const FramePlan& plan, const std::string& name,
                                    std::string (*describe)(const FramePlan&, PassId)) {
    Result<std::vector<PassId>> passes = named_passes(plan, name);
    if (!passes) return passes.take_errors();
    std::string text;
    for (const PassId pass : *passes) text += describe(plan, pass);
    return text;
}

}  // namespace weft
