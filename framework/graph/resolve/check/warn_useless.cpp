// Warns about resources that no pass reads, and about passes without effect. A resource also counts as read
// if only a removed pass, an unused "else", a debug view or a test names it. Such a resource may be read with
// other parameter values, or when the view is shown or the test runs.
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
        for (ResourceId id(0); id < graph_.resources.size(); ++id) judge_resource(id);
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
        for (const auto& [name, list] : declared_.input.graph.views)
            if (list.buffer) add_names(*list.buffer, read_);
        seen_.assign(graph_.resources.size(), 0);
        written_ = seen_;
        for (PassId pass(0); pass < graph_.passes.size(); ++pass) {
            const PassDecl& decl = graph_.passes[pass];
            for (size_t i = 0; i < decl.uses.size(); ++i) {
                const UseDecl& use = decl.uses[i];
                if (sees(decl, versioned_.passes[pass].ports[i], use)) seen_[use.resource] = 1;
                if (writes(use.access) && live_.live_passes[pass]) written_[use.resource] = 1;
            }
        }
    }

    // Returns true if a use needs the content of the resource. Some writes need the content too: a depth
    // attachment is used by the depth or stencil test, and a multisampled attachment is used by its resolve.
    static bool sees(const PassDecl& decl, const PortDraft& port, const UseDecl& use) {
        if (reads(use.access)) return true;
        if (port.is_depth_port) return decl.state.depth_test || decl.state.stencil_test;
        return std::ranges::any_of(decl.colors, [&](const AttachmentDecl& color) {
            return color.resolve_use != kNoId && &decl.uses[color.use] == &use;
        });
    }

    // Warns if nothing reads the resource although a live pass writes it. If only useless passes write it,
    // judge_pass() warns about these passes instead.
    void judge_resource(ResourceId id) {
        const ResourceDecl& resource = graph_.resources[id];
        if (resource.lifetime != ResourceLifetime::transient || seen_[id] || !written_[id]) return;
        if (read_.contains(resource.name) || at_times_.contains(resource.name)) return;
        reporter_.warn(resource.loc, "W135",
                       "resource " + quote(resource.name) + " is written, but no pass reads it",
                       "read the resource, show it in a \"debug\" view, or remove the passes that write it");
    }

    bool is_for_other_times(const PassDesc& desc) const {
        const auto at_times = [&](const PortDesc* port) { return at_times_.contains(port->ref.name); };
        return !desc.condition.empty() || std::ranges::any_of(written_ports(desc), at_times);
    }

    // Warns if the pass `name` is culled; with a repeat, if all its passes `ids` are culled. If a chain of
    // passes is culled, warns only about the last pass of the chain. This pass is the cause, because nothing
    // reads its result.
    void judge_pass(const std::string& name, const std::vector<PassId>& ids) {
        const auto is_culled = [&](PassId id) { return live_.live_passes[id] == 0; };
        const auto is_cause = [&](PassId id) { return live_.reasons[id] == CullReason::unused_output; };
        if (ids.empty() || !std::ranges::all_of(ids, is_culled)) return;
        if (declared_.expansion.carries.contains(name)) return;
        const auto cause = std::ranges::find_if(ids, is_cause);
        if (cause == ids.end() || is_for_other_times(*declared_.expansion.passes[*cause].desc)) return;
        reporter_.warn(declared_.expansion.passes[*cause].desc->loc, "W136",
                       "pass " + quote(name) + " does not run: " + live_.details[*cause],
                       "read its result in a pass that the output depends on, or remove the pass");
    }

    const Declared& declared_;
    const VersionedGraph& versioned_;
    const ResolvedGraph& graph_;
    Reporter& reporter_;
    LiveGraph live_;
    // Names of the resources that passes read, including passes that do not run.
    ResourceNames read_;
    // Names of the resources that debug views or tests use, and of the resources that inputs of removed
    // passes or an "else" name. Parameter values may decide whether those inputs or the "else" are used.
    ResourceNames at_times_;
    // Indexed by ResourceId: 1 if a pass of the resolved graph, live or culled, needs the earlier content of
    // the resource.
    std::vector<uint8_t> seen_;
    // Indexed by ResourceId: 1 if a live pass writes the resource.
    std::vector<uint8_t> written_;
};

}  // namespace

// Runs only if no error was reported and no pass is suspect, because a pass with an error may read or write
// resources that are not known here.
void warn_useless(const Declared& declared, const VersionedGraph& versioned, const ResolvedGraph& graph,
                  const Suspects& suspects, Reporter& reporter) {
    const bool faulty = std::ranges::find(suspects.passes, 1) != suspects.passes.end();
    if (!reporter.has_errors() && !faulty) UselessSearch(declared, versioned, graph, reporter).run();
}

}  // namespace weft
