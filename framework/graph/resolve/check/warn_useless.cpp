// Warns about resources that no pass reads and about passes without effect. A use that depends on an `if`, an
// "else", a view or a test counts as a use, because it has an effect in some cases.
#include <algorithm>

#include "graph/resolve/check/resource_names.h"
#include "graph/resolve/checks.h"
#include "graph/resolve/cull.h"
#include "graph/resolve/fault_text.h"
#include "graph/resolve/pass_ports.h"

namespace weft {
namespace {

class UselessSearch {
 public:
    UselessSearch(const Declared& declared, const VersionedGraph& versioned, const ResolvedGraph& graph,
                  Reporter& reporter)
        : declared_(declared),
          versioned_(versioned),
          graph_(graph),
          reporter_(reporter),
          live_(cull(graph)) {}

    void run() {
        gather();
        for (ResourceId id = 0; id < graph_.resources.size(); ++id) judge_resource(id);
        for (const auto& [name, ids] : declared_.expansion.instances) judge_pass(name, ids);
    }

 private:
    void gather() {
        at_times_ = watched_resources(declared_.input.graph);
        for (const auto& [name, desc] : declared_.input.graph.passes) {
            add_inputs(desc, read_);
            if (declared_.expansion.dropped.contains(name)) add_inputs(desc, at_times_);
            for (const PortDesc& port : desc.in)
                if (port.otherwise) add_names(port, at_times_);
        }
        seen_.assign(graph_.resources.size(), 0);
        written_ = seen_;
        for (PassId pass = 0; pass < graph_.passes.size(); ++pass) {
            const PassDecl& decl = graph_.passes[pass];
            for (size_t i = 0; i < decl.uses.size(); ++i) {
                const UseDecl& use = decl.uses[i];
                if (sees(decl, versioned_.passes[pass].ports[i], use)) seen_[use.resource] = 1;
                if (writes(use.access) && live_.live_passes[pass]) written_[use.resource] = 1;
            }
        }
    }

    // A depth buffer is used by the pass that tests against it, and a multisampled image by the pass that
    // resolves it.
    static bool sees(const PassDecl& decl, const PortDraft& port, const UseDecl& use) {
        if (reads(use.access)) return true;
        if (port.is_depth_port) return decl.state.depth_test || decl.state.stencil_test;
        return std::ranges::any_of(decl.colors, [&](const AttachmentDecl& color) {
            return color.resolve_use != kNoId && &decl.uses[color.use] == &use;
        });
    }

    // If only useless passes write it, these passes get the warning.
    void judge_resource(ResourceId id) {
        const ResourceDecl& resource = graph_.resources[id];
        if (resource.lifetime != ResourceLifetime::transient || seen_[id] || !written_[id]) return;
        if (read_.contains(resource.name) || at_times_.contains(resource.name)) return;
        reporter_.warn(resource.loc, "W135",
                       "resource " + quote(resource.name) + " is written, but nothing reads it",
                       "read it, show it in a \"debug\" view, or leave out what writes it");
    }

    bool is_for_other_times(const PassDesc& desc) const {
        const auto at_times = [&](const PortDesc* port) { return at_times_.contains(port->ref.name); };
        return !desc.condition.empty() || std::ranges::any_of(written_ports(desc), at_times);
    }

    // If several passes are culled together, only the last one is named, because it is the cause.
    void judge_pass(const std::string& name, const std::vector<PassId>& ids) {
        const auto is_culled = [&](PassId id) { return live_.live_passes[id] == 0; };
        const auto is_cause = [&](PassId id) { return live_.reasons[id] == CullReason::unused_output; };
        if (ids.empty() || !std::ranges::all_of(ids, is_culled)) return;
        const auto cause = std::ranges::find_if(ids, is_cause);
        if (cause == ids.end() || is_for_other_times(*declared_.expansion.passes[*cause].desc)) return;
        reporter_.warn(declared_.expansion.passes[*cause].desc->loc, "W136",
                       "pass " + quote(name) + " is left out: " + live_.details[*cause],
                       "let a pass that leads to the output read what it writes, or remove it");
    }

    const Declared& declared_;
    const VersionedGraph& versioned_;
    const ResolvedGraph& graph_;
    Reporter& reporter_;
    LiveGraph live_;
    ResourceNames read_;            // by passes, including those that do not run
    ResourceNames at_times_;        // by views, tests, and with other values of parameters
    std::vector<uint8_t> seen_;     // index: ResourceId; used by the existing passes
    std::vector<uint8_t> written_;  // by ResourceId: by passes that run
};

}  // namespace

// A faulty pass may read or write unknown resources.
void warn_useless(const Declared& declared, const VersionedGraph& versioned, const ResolvedGraph& graph,
                  const Suspects& suspects, Reporter& reporter) {
    const bool faulty = std::ranges::find(suspects.passes, 1) != suspects.passes.end();
    if (!reporter.has_errors() && !faulty) UselessSearch(declared, versioned, graph, reporter).run();
}

}  // namespace weft
