// What is there or done for nothing: resources that no pass uses or nobody reads, and passes that nothing
// comes of. What depends on an `if`, an "else", a view or a test is let pass: at times it is for something.
#include <algorithm>

#include "graph/resolve/resolve_context.h"

namespace weft {
namespace {

using Names = std::set<std::string, std::less<>>;

void add_names(const PortDesc& port, Names& names) {
    names.insert(port.ref.name);
    if (port.otherwise) names.insert(port.otherwise->name);
}

void add_inputs(const PassDesc& desc, Names& names) {
    for (const PortDesc& port : desc.in) add_names(port, names);
    if (desc.indirect) add_names(*desc.indirect, names);
}

class UselessStep {
 public:
    explicit UselessStep(ResolveState& state) : state_(state), live_(cull(state.graph)) {}

    void run() {
        gather();
        for (ResourceId id = 0; id < state_.graph.resources.size(); ++id) judge_resource(id);
        for (const auto& [name, ids] : state_.instances) judge_pass(name, ids);
    }

 private:
    void gather() {
        at_times_ = watched_resources(state_.input.graph);
        for (const auto& [name, desc] : state_.input.graph.passes) {
            add_inputs(desc, read_);
            if (state_.dropped.contains(name)) add_inputs(desc, at_times_);
            for (const PortDesc& port : desc.in)
                if (port.otherwise) add_names(port, at_times_);
        }
        seen_.assign(state_.graph.resources.size(), 0);
        written_ = seen_;
        for (PassId pass = 0; pass < state_.passes.size(); ++pass) {
            const PassDecl& decl = state_.graph.passes[pass];
            for (size_t i = 0; i < decl.uses.size(); ++i) {
                const UseDecl& use = decl.uses[i];
                if (sees(decl, state_.passes[pass].ports[i], use)) seen_[use.resource] = 1;
                if (writes(use.access) && live_.live_passes[pass]) written_[use.resource] = 1;
            }
        }
    }

    // A depth buffer serves the pass that tests against it, and a multisampled image the one that resolves
    // it.
    static bool sees(const PassDecl& decl, const PortWork& port, const UseDecl& use) {
        if (reads(use.access)) return true;
        if (port.is_depth_port) return decl.state.depth_test || decl.state.stencil_test;
        return std::ranges::any_of(decl.colors, [&](const AttachmentDecl& color) {
            return color.resolve_use != kNoId && &decl.uses[color.use] == &use;
        });
    }

    // What only useless passes write is those passes' fault.
    void judge_resource(ResourceId id) {
        const ResourceDecl& resource = state_.graph.resources[id];
        if (resource.lifetime != ResourceLifetime::transient || seen_[id] || !written_[id]) return;
        if (read_.contains(resource.name) || at_times_.contains(resource.name)) return;
        state_.warn(resource.loc, "W135",
                    "resource " + quoted(resource.name) + " is written, but nothing reads it",
                    "read it, show it in a \"debug\" view, or leave out what writes it");
    }

    bool is_for_other_times(const PassDesc& desc) const {
        const auto at_times = [&](const PortDesc* port) { return at_times_.contains(port->ref.name); };
        return !desc.condition.empty() || std::ranges::any_of(written_ports(desc), at_times);
    }

    // Of passes that fall with others, only the last one is named: it is their cause.
    void judge_pass(const std::string& name, const std::vector<PassId>& ids) {
        const auto is_culled = [&](PassId id) { return live_.live_passes[id] == 0; };
        const auto is_cause = [&](PassId id) { return live_.reasons[id] == CullReason::unused_output; };
        if (ids.empty() || !std::ranges::all_of(ids, is_culled)) return;
        const auto cause = std::ranges::find_if(ids, is_cause);
        if (cause == ids.end() || is_for_other_times(*state_.passes[*cause].desc)) return;
        state_.warn(state_.passes[*cause].desc->loc, "W136",
                    "pass " + quoted(name) + " is left out: " + live_.details[*cause],
                    "let a pass that leads to the output read what it writes, or remove it");
    }

    ResolveState& state_;
    LiveGraph live_;
    Names read_;                    // by passes, whether they run or not
    Names at_times_;                // by views, tests, and where the parameters stand otherwise
    std::vector<uint8_t> seen_;     // by ResourceId: by the passes that there are
    std::vector<uint8_t> written_;  // by ResourceId: by passes that run
};

}  // namespace

std::set<std::string, std::less<>> watched_resources(const GraphDesc& graph) {
    Names watched;
    for (const auto& [name, view] : graph.debug) watched.insert(view.show.name);
    for (const GraphTestDesc& test : graph.tests)
        for (const ExpectationDesc& expectation : test.expect)
            watched.insert(expectation.ref.substr(0, expectation.ref.find_first_of("@[.")));
    return watched;
}

// What a left-out pass, or a port that took its "else", names is used when the parameters stand otherwise.
void warn_unused(ResolveState& state) {
    Names used;
    for (const auto& [name, desc] : state.input.graph.passes) {
        add_inputs(desc, used);
        for (const PortDesc* port : written_ports(desc)) add_names(*port, used);
    }
    for (ResourceId id = 0; id < state.graph.resources.size(); ++id) {
        const ResourceDecl& resource = state.graph.resources[id];
        if (used.contains(resource.name) || !state.resources[id].desc || resource.age > 0) continue;
        if (state.is_included(resource.loc)) continue;
        state.warn(resource.loc, "W130", "no pass uses resource " + quoted(resource.name),
                   "remove it, or use it");
    }
}

// A pass with a fault may read or write what nobody knows of.
void warn_useless(ResolveState& state) {
    const bool faulty = std::ranges::any_of(state.passes, &PassWork::faulty);
    if (state.errors.empty() && !faulty) UselessStep(state).run();
}

}  // namespace weft
