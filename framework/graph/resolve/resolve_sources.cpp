#include "graph/resolve/resolve_sources.h"

#include <algorithm>
#include <tuple>

#include "graph/resolve/resolve_presence.h"

namespace weft {
namespace {

// What one use sees, gathered over its cells.
struct Seen {
    std::vector<VersionSource> sources;  // by cell
    std::vector<VersionSource> nothing;  // cells without any content; the producer has no meaning
    bool this_frame = false;             // some content is of this frame
    bool unknown = false;                // some cell's writers have no order: reported
};

class VersionConnector {
 public:
    VersionConnector(ResolveState& state, const std::vector<Cell>& cells) : state_(state), cells_(cells) {}

    void run() {
        seen_.resize(state_.passes.size());
        for (PassId pass = 0; pass < seen_.size(); ++pass)
            seen_[pass].resize(state_.graph.passes[pass].uses.size());
        for (const Cell& cell : cells_) gather(cell);
        const auto known = static_cast<std::ptrdiff_t>(state_.errors.size());
        for (PassId pass = 0; pass < seen_.size(); ++pass) finish_pass(pass);
        std::stable_sort(state_.errors.begin() + known, state_.errors.end(), stands_before);
        sort_edges();
    }

 private:
    // In the file; passes come by name.
    static bool stands_before(const Diagnostic& a, const Diagnostic& b) {
        return std::tie(a.file, a.line, a.column) < std::tie(b.file, b.line, b.column);
    }

    UseDecl& use(const CellUse& u) { return state_.graph.passes[u.pass].uses[u.use]; }
    PortWork& port(const CellUse& u) { return state_.passes[u.pass].ports[u.use]; }

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
        const int version = version_seen(state_, cell, u);
        if (version >= 0) {
            const PassId producer = cell.writers[static_cast<size_t>(version)].pass;
            seen.sources.push_back({cell.range, producer});
            seen.this_frame = true;
        } else if (state_.resources[cell.resource].has_content) {
            seen.sources.push_back({cell.range, kNoId});
        } else {
            seen.nothing.push_back({cell.range, kNoId});
        }
        const auto next = static_cast<size_t>(version + 1);
        const bool only_writes = writes(use(u).access) && port(u).rank == WriteRank::fresh;
        if (!only_writes && next < cell.writers.size()) add_edge(u.pass, cell.writers[next], EdgeKind::war);
    }

    void add_edge(PassId from, const CellUse& to, EdgeKind kind) {
        if (from != to.pass)
            state_.graph.edges.push_back({from, to.pass, kind, use(to).resource, use(to).loc});
    }

    void finish_pass(PassId pass) {
        PassDecl& decl = state_.graph.passes[pass];
        for (uint32_t i = 0; i < decl.uses.size(); ++i) {
            const CellUse u{pass, i};
            if (decl.uses[i].access == Access::none) continue;
            settle_access(u);
            settle_state(u);
            if (sees_content(u)) {
                decl.uses[i].sources = merged_sources(seen_[pass][i].sources);
                for (const VersionSource& source : decl.uses[i].sources) {
                    if (source.producer != kNoId) add_edge(source.producer, u, EdgeKind::raw);
                }
            }
            if (must_find_content(u)) check_content(u);
        }
    }

    // An attachment or storage write that goes on with older content reads it.
    void settle_access(const CellUse& u) {
        const Seen& seen = seen_[u.pass][u.use];
        const WriteRank rank = port(u).rank;
        if (rank == WriteRank::fresh) return;
        const bool any = !seen.sources.empty();
        const bool in_place = rank == WriteRank::in_place;
        const bool loads = seen.this_frame || (in_place && any);
        Access& a = use(u).access;
        if (a == Access::storage_write && (any || in_place)) a = Access::storage_read_write;
        // What was in an import before the frame is cleared by the first raster write, as everything is.
        if (a == Access::color_write && loads) a = Access::color_read_write;
        if (a == Access::depth_write && loads) a = Access::depth_read_write;
    }

    void settle_state(const CellUse& u) {
        UseDecl& decl = use(u);
        const ResourceDecl& resource = state_.graph.resources[decl.resource];
        const bool buffer = resource.kind == ResourceKind::buffer;
        const ShaderStageMask stages =
            port(u).binding ? port(u).binding->stages : stage_bit(ShaderStage::compute);
        decl.state = access_state(decl.access, stages, buffer ? aspect::kNone : resource.aspects);
    }

    // A partial copy or clear keeps the rest of the old content, though its access reads nothing.
    bool sees_content(const CellUse& u) {
        return reads(use(u).access) || port(u).rank == WriteRank::in_place;
    }

    // Attachments are cleared and buffers left as they are when nothing came before; a port that reads needs
    // content.
    bool must_find_content(const CellUse& u) {
        const Access a = use(u).access;
        if (!writes(a)) return true;
        return port(u).reads_own_port || keeps_the_rest(u) || (state_.passes[u.pass].custom && reads(a)) ||
               wants_last_frame(u);
    }

    // Its author says that the preceding version stays where this pass does not write. An attachment without
    // one is cleared.
    bool keeps_the_rest(const CellUse& u) {
        const PortWork& work = port(u);
        const bool attachment = work.color_output != nullptr || work.is_depth_port;
        return !attachment && work.rank == WriteRank::in_place &&
               (state_.passes[u.pass].desc->partial || work.pinned());
    }

    // Going on where nothing is in this frame's copy of a history: its author means the last one.
    bool wants_last_frame(const CellUse& u) {
        if (state_.graph.resources[use(u).resource].history == 0) return false;
        const WriteRank rank = port(u).rank;
        return rank == WriteRank::in_place || (rank == WriteRank::resumes && use(u).binding != kNoId);
    }

    void check_content(const CellUse& u) {
        const Seen& seen = seen_[u.pass][u.use];
        const ResourceDecl& resource = state_.graph.resources[use(u).resource];
        const ResourceWork& work = state_.resources[use(u).resource];
        if (seen.nothing.empty() || seen.unknown || port(u).is_reported) return;
        if (work.suspect_writers || work.suspect_shape) return;
        const std::vector<VersionSource> missing = merged_sources(seen.nothing);
        const bool observer = state_.observers.contains(state_.pass_name(u.pass));
        const std::string who = observer ? "the observer" : "pass " + quoted(state_.pass_name(u.pass));
        const bool writes_it_too = written_by(u);
        const std::string what = quoted(range_of(resource, missing.front().range));
        const bool partial = writes(use(u).access) && state_.passes[u.pass].desc->partial;
        Diagnostic& d =
            state_.pass_error(u.pass, use(u).loc, "W110",
                              partial ? who + " writes only a part of " + what +
                                            " (\"partial\"), and no pass writes the rest before it"
                                      : who + " reads " + what +
                                            (writes_it_too ? " before any other pass writes it"
                                                           : ", which no pass writes before it"));
        if (partial && resource.history == 0)
            add_help(
                d,
                "fill it first, for example with a pass of type \"clear\"; or, if this pass writes all of "
                "it, remove \"partial\"");
        if (resource.history > 0) {
            const std::string last = role_name(resource.name, 1);
            add_help(d, "every frame begins with an empty copy; what the last one left is " + quoted(last) +
                            ": read that, and write " + quoted(resource.name));
        }
        if (const PassDesc* dropped = dropped_writer(state_, resource.name)) {
            add_help(d, "pass " + quoted(dropped->name) + ", which would write it, is left out");
        } else if (written_at_all(use(u).resource, u.pass)) {
            add_help(
                d, "other parts or later versions of it are written: check the mips and layers, and the pin");
        } else if (resource.lifetime == ResourceLifetime::imported) {
            add_help(d, "the import has no content when the frame begins: write it first");
        } else if (resource.history == 0 && !partial) {
            add_help(d, "write it in the \"out\" of a pass, or import it");
        }
    }

    bool written_by(const CellUse& u) {
        return std::ranges::any_of(state_.graph.passes[u.pass].uses, [&](const UseDecl& other) {
            return writes(other.access) && other.resource == use(u).resource &&
                   overlaps(other.range, use(u).range);
        });
    }

    bool written_at_all(ResourceId resource, PassId except) const {
        for (PassId pass = 0; pass < state_.passes.size(); ++pass) {
            if (pass == except) continue;
            for (const UseDecl& other : state_.graph.passes[pass].uses) {
                if (other.resource == resource && writes(other.access)) return true;
            }
        }
        return false;
    }

    void sort_edges() {
        const auto key = [](const EdgeDecl& e) { return std::tuple(e.to, e.from, e.kind, e.resource); };
        std::vector<EdgeDecl>& edges = state_.graph.edges;
        std::ranges::stable_sort(edges, {}, key);
        // Not std::ranges::unique: clang 14 can't compile what it returns with libstdc++ 12.
        const auto equal = [&](const EdgeDecl& a, const EdgeDecl& b) { return key(a) == key(b); };
        edges.erase(std::unique(edges.begin(), edges.end(), equal), edges.end());
    }

    ResolveState& state_;
    const std::vector<Cell>& cells_;
    std::vector<std::vector<Seen>> seen_;  // by pass, by use
};

}  // namespace

std::span<const PassId> visible_pins(const PortWork& port, PassId pass) {
    const auto own = std::ranges::find(port.pins, pass);
    return {port.pins.begin(), own};
}

int version_seen(const ResolveState& state, const Cell& cell, const CellUse& reader) {
    const PortWork& port = state.passes[reader.pass].ports[reader.use];
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

void connect_versions(ResolveState& state, const std::vector<Cell>& cells) {
    VersionConnector(state, cells).run();
}

}  // namespace weft
