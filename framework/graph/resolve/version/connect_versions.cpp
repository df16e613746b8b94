#include "graph/resolve/version/connect_versions.h"

#include <algorithm>
#include <tuple>

#include "graph/resolve/dropped_writer.h"
#include "graph/resolve/fault_text.h"
#include "graph/resolve/rings.h"
#include "graph/resolve/version/cell_stage.h"

namespace weft {
namespace {

// The content that one use sees, collected from all cells of its range. A cell is a part of a resource that
// every use covers completely or not at all.
struct Seen {
    // The version seen in each cell that has content.
    std::vector<VersionSource> sources;
    // The cells that have no content; `producer` has no meaning for these.
    std::vector<VersionSource> nothing;
    // True if the use sees content that a pass of this frame has written. A pass that carries the content of
    // the last frame does not count.
    bool this_frame = false;
    // True if the order of the writers is unknown in some cell of the use's range. An error about that was
    // reported.
    bool unknown = false;
};

class VersionConnector : CellStage {
 public:
    using CellStage::CellStage;

    void run() {
        seen_.resize(graph_.passes.size());
        for (PassId pass(0); pass < seen_.size(); ++pass) seen_[pass].resize(graph_.passes[pass].uses.size());
        for (const Cell& cell : cells_) gather(cell);
        const size_t known = reporter_.error_count();
        for (PassId pass(0); pass < seen_.size(); ++pass) finish_pass(pass);
        // finish_pass() has reported errors in the order of the pass names. This call sorts these errors by
        // their place in the file.
        reporter_.sort_errors(known);
        sort_edges();
    }

 private:
    PortDraft& port(const CellUse& u) { return graph_.passes[u.pass].ports[u.use]; }

    void gather(const Cell& cell) {
        for (const CellUse& reader : cell.readers) gather(cell, reader);
        for (const CellUse& writer : cell.writers) gather(cell, writer);
        if (!cell.ordered) return;
        for (size_t i = 1; i < cell.writers.size(); ++i) {
            add_edge(cell.writers[i - 1].pass, cell.writers[i], EdgeKind::waw);
        }
    }

    void gather(const Cell& cell, const CellUse& u) {
        Seen& seen = seen_[u.pass][u.use];
        if (!cell.ordered) {
            seen.unknown = true;
            return;
        }
        const int version = version_seen(graph_, cell, u);
        if (version >= 0) {
            const PassId producer = cell.writers[static_cast<size_t>(version)].pass;
            seen.sources.push_back({cell.range, producer});
            seen.this_frame |= !declared_.expansion.passes[producer].decl.carries;
        } else if (declared_.shapes.origins[cell.resource].has_content) {
            seen.sources.push_back({cell.range, kNoId});
        } else {
            seen.nothing.push_back({cell.range, kNoId});
        }
        const auto next = static_cast<size_t>(version + 1);
        const bool only_writes = writes(use(u).access) && port(u).rank == WriteRank::fresh;
        if (!only_writes && next < cell.writers.size()) add_edge(u.pass, cell.writers[next], EdgeKind::war);
    }

    void add_edge(PassId from, const CellUse& to, EdgeKind kind) {
        if (from != to.pass) graph_.edges.push_back({from, to.pass, kind, use(to).resource, use(to).loc});
    }

    void finish_pass(PassId pass) {
        BoundPass& bound = graph_.passes[pass];
        for (uint32_t i = 0; i < bound.uses.size(); ++i) {
            const CellUse u{pass, i};
            if (bound.uses[i].access == Access::none) continue;
            settle_access(u);
            settle_state(u);
            if (sees_content(u)) {
                bound.uses[i].sources = merge_sources(seen_[pass][i].sources);
                for (const VersionSource& source : bound.uses[i].sources) {
                    if (source.producer != kNoId) add_edge(source.producer, u, EdgeKind::raw);
                }
            }
            if (must_find_content(u)) check_content(u);
        }
    }

    // If an attachment write or a storage write continues older content, changes its access to one that reads
    // and writes.
    void settle_access(const CellUse& u) {
        const Seen& seen = seen_[u.pass][u.use];
        const WriteRank rank = port(u).rank;
        if (rank == WriteRank::fresh) return;
        const bool any = !seen.sources.empty();
        const bool in_place = rank == WriteRank::in_place;
        const bool loads = seen.this_frame || (in_place && any);
        Access& a = use(u).access;
        if (a == Access::storage_write && (any || in_place)) a = Access::storage_read_write;
        // An attachment is loaded only if it continues content of this frame or is written in place.
        // Otherwise its old content is not loaded, even if an import had content before the frame.
        if (a == Access::color_write && loads) a = Access::color_read_write;
        if (a == Access::depth_write && loads) a = Access::depth_read_write;
    }

    void settle_state(const CellUse& u) {
        UseDecl& decl = use(u);
        const ResourceDecl& resource = graph_.resources[decl.resource];
        const bool buffer = resource.kind == ResourceKind::buffer;
        decl.state = access_state(decl.access, stages_of(u), buffer ? aspect::kNone : resource.aspects);
    }

    // Returns the shader stages that access the port of a use: those of the shader's binding, or those that
    // the type of a C++ pass declares.
    ShaderStageMask stages_of(const CellUse& u) {
        if (port(u).binding) return port(u).binding->stages;
        if (const PassType* type = declared_.expansion.passes[u.pass].custom)
            for (const PortDecl& declared : type->ports)
                if (declared.name == use(u).port && declared.is_output == use(u).is_output)
                    return declared.stages;
        return stage_bit(ShaderStage::compute);
    }

    // Returns true if the use needs the earlier content. For example, a partial copy or clear reads nothing,
    // but the earlier content must stay in the part of the resource that the pass does not write.
    bool sees_content(const CellUse& u) {
        return reads(use(u).access) || port(u).rank == WriteRank::in_place;
    }

    // Returns true if missing earlier content is an error. A read always needs content. Most writes do not:
    // without earlier content, an attachment is cleared and a buffer starts undefined.
    bool must_find_content(const CellUse& u) {
        const Access a = use(u).access;
        if (!writes(a)) return true;
        return port(u).reads_own_port || keeps_the_rest(u) ||
               (declared_.expansion.passes[u.pass].custom && reads(a)) || wants_last_frame(u);
    }

    // Returns true if the author declares, with "partial" or `@pass`, that the previous version stays visible
    // where this pass does not write. Returns false for attachments, which are cleared if there is no
    // previous version.
    bool keeps_the_rest(const CellUse& u) {
        const PortDraft& draft = port(u);
        const bool attachment = draft.color_output != nullptr || draft.is_depth_port;
        return !attachment && draft.rank == WriteRank::in_place &&
               (declared_.expansion.passes[u.pass].desc->partial || draft.pinned());
    }

    // Returns true if the pass continues the content of a resource with history. This frame's copy of such a
    // resource begins empty, so the author probably means the copy of the previous frame.
    bool wants_last_frame(const CellUse& u) {
        if (graph_.resources[use(u).resource].history == 0) return false;
        const WriteRank rank = port(u).rank;
        return rank == WriteRank::in_place || (rank == WriteRank::resumes && use(u).binding != kNoId);
    }

    void check_content(const CellUse& u) {
        const Seen& seen = seen_[u.pass][u.use];
        const ResourceDecl& resource = graph_.resources[use(u).resource];
        const Suspects& suspects = graph_.suspects;
        if (seen.nothing.empty() || seen.unknown || suspects.uses[u.pass][u.use]) return;
        if (suspects.writers[use(u).resource] || suspects.shapes[use(u).resource]) return;
        const std::vector<VersionSource> missing = merge_sources(seen.nothing);
        const std::string who = name_reader(declared_.expansion.passes[u.pass]);
        const bool writes_it_too = written_by(u);
        const std::string what = quote(range_of(resource, missing.front().range));
        const bool partial = writes(use(u).access) && declared_.expansion.passes[u.pass].desc->partial;
        Diagnostic& d = report_.error(u.pass, use(u).loc, "W110",
                                      partial ? who + " writes only a part of " + what +
                                                    " (\"partial\"), but no earlier pass writes the rest"
                                              : who + " reads " + what +
                                                    (writes_it_too ? " before any other pass writes it"
                                                                   : ", which no earlier pass writes"));
        if (partial && resource.history == 0)
            add_help(d,
                     "fill the resource first, for example in a pass of type \"clear\"; or remove "
                     "\"partial\", if this pass "
                     "writes all of the resource");
        if (resource.history > 0) {
            const std::string last = role_name(resource.name, 1);
            add_help(d,
                     "a resource with \"history\" has an empty copy at the beginning of each frame. Read " +
                         quote(last) +
                         " to get the content of the previous frame, and write the new content to " +
                         quote(resource.name));
        }
        if (const PassDesc* dropped = dropped_writer(declared_.expansion, resource.name, reporter_)) {
            add_help(d, "pass " + quote(dropped->name) +
                            " would write the resource, but is removed: its \"if\" is false or its "
                            "\"repeat\" is empty");
        } else if (written_at_all(use(u).resource, u.pass)) {
            add_help(d,
                     "check the mips, layers, elements and the @pass of the reference: passes write other "
                     "parts or "
                     "later versions");
        } else if (resource.lifetime == ResourceLifetime::imported) {
            add_help(d, "write the import in an earlier pass: it has no content when the frame begins");
        } else if (resource.history == 0 && !partial) {
            add_help(d,
                     "add " + quote(resource.name) + " to \"out\" of a pass that runs earlier, or import it");
        }
    }

    bool written_by(const CellUse& u) {
        return std::ranges::any_of(graph_.passes[u.pass].uses, [&](const UseDecl& other) {
            return writes(other.access) && other.resource == use(u).resource &&
                   overlaps(other.range, use(u).range);
        });
    }

    bool written_at_all(ResourceId resource, PassId except) const {
        for (PassId pass(0); pass < graph_.passes.size(); ++pass) {
            if (pass == except) continue;
            for (const UseDecl& other : graph_.passes[pass].uses) {
                if (other.resource == resource && writes(other.access)) return true;
            }
        }
        return false;
    }

    void sort_edges() {
        const auto key = [](const EdgeDecl& e) { return std::tuple(e.to, e.from, e.kind, e.resource); };
        std::vector<EdgeDecl>& edges = graph_.edges;
        std::ranges::stable_sort(edges, {}, key);
        // std::ranges::unique is not used here, because clang 14 cannot compile its result with libstdc++ 12.
        const auto equal = [&](const EdgeDecl& a, const EdgeDecl& b) { return key(a) == key(b); };
        edges.erase(std::unique(edges.begin(), edges.end(), equal), edges.end());
    }

    // The content that each use sees, indexed by PassId, then by use.
    std::vector<std::vector<Seen>> seen_;
};

}  // namespace

std::span<const PassId> visible_pins(const PortDraft& port, PassId pass) {
    const auto own = std::ranges::find(port.pins, pass);
    return {port.pins.begin(), own};
}

int version_seen(const VersionedGraph& graph, const Cell& cell, const CellUse& reader) {
    const PortDraft& port = graph.passes[reader.pass].ports[reader.use];
    if (cell.before_round.contains(reader)) return -1;
    const int own = cell.writer_index(reader.pass);
    if (!port.pinned()) return own >= 0 ? own - 1 : static_cast<int>(cell.writers.size()) - 1;
    int last = -1;
    for (const PassId pin : visible_pins(port, reader.pass)) last = std::max(last, cell.writer_index(pin));
    if (last >= 0) return last;
    const auto before = cell.foreign_pins.find(reader);
    if (before == cell.foreign_pins.end()) return last;
    for (const PassId writer : before->second) last = std::max(last, cell.writer_index(writer));
    return last;
}

void connect_versions(const Declared& declared, const std::vector<Cell>& cells, VersionedGraph& graph,
                      Reporter& reporter) {
    VersionConnector(declared, cells, graph, reporter).run();
}

}  // namespace weft
