// Versions are per cell. First everything that orders passes is gathered: `after`, pins, reads that must
// follow all writers. Then each cell's writers are put in order, which gives new orderings (a version's
// readers run before the next writer), until nothing changes. Writers still without order are W111; a loop at
// any time is W150.
#include <algorithm>
#include <set>

#include "graph/resolve/resolve_cells.h"
#include "graph/resolve/resolve_order.h"
#include "graph/resolve/resolve_sources.h"

namespace weft {
namespace {

class VersionOrder {
 public:
    VersionOrder(ResolveState& state, std::vector<Cell>& cells)
        : state_(state), cells_(cells), order_(state.passes.size()) {}

    // False when there is a cycle: then nothing can be said about versions.
    bool run() {
        add_after();
        for (Cell& cell : cells_) add_known(cell);
        if (!sorted()) return false;
        if (!add_foreign_pins()) return false;
        return order_writers();
    }

    void report_unordered() {
        std::set<std::pair<const PassDesc*, const PassDesc*>> reported;
        for (Cell& cell : cells_) {
            if (cell.ordered || state_.resources[cell.resource].suspect_writers) continue;
            sort_by_position(cell);
            for (size_t i = 1; i < cell.writers.size(); ++i) {
                const PassId a = cell.writers[i - 1].pass;
                const PassId b = cell.writers[i].pass;
                pay(use(cell.writers[i]).loc);
                if (order_.reaches(a, b)) continue;
                if (reported.insert(std::minmax(state_.passes[a].desc, state_.passes[b].desc)).second)
                    report_pair(cell, cell.writers[i - 1], cell.writers[i]);
            }
        }
    }

 private:
    const UseDecl& use(const CellUse& u) const { return state_.graph.passes[u.pass].uses[u.use]; }
    const PortWork& port(const CellUse& u) const { return state_.passes[u.pass].ports[u.use]; }

    // Counts the steps that searches of the order took since the last call.
    void pay(SourceLoc loc) {
        state_.spend(order_.work() - paid_, loc);
        paid_ = order_.work();
    }

    // Looking for one writer of a cell: many are compared in the time of a step.
    static uint64_t search_steps(const Cell& cell) {
        constexpr size_t kWritersPerStep = 64;
        return 1 + cell.writers.size() / kWritersPerStep;
    }

    // Keeping an arc costs more than looking at it.
    void add_arc(const OrderArc& arc) {
        constexpr uint64_t kStepsPerArc = 4;
        state_.spend(kStepsPerArc, arc.loc);
        order_.add(arc);
    }

    bool sorted() {
        pay(state_.passes.empty() ? SourceLoc{} : state_.passes.front().desc->loc);
        if (order_.sort()) return true;
        report_cycles(state_, order_);
        return false;
    }

    void add_after() {
        for (PassId pass = 0; pass < state_.passes.size(); ++pass) {
            const PassDesc& desc = *state_.passes[pass].desc;
            for (size_t i = 0; i < desc.after.size(); ++i) {
                const SourceLoc loc = i < desc.after_locs.size() ? desc.after_locs[i] : desc.loc;
                add_after(pass, desc.after[i], loc);
            }
        }
    }

    void add_after(PassId pass, const std::string& name, SourceLoc loc) {
        const auto found = state_.instances.find(name);
        const bool itself = name == state_.author_name(pass);
        if (found != state_.instances.end() && !itself) {
            for (const PassId from : found->second) {
                add_arc({from, pass, EdgeKind::after, kNoId, loc});
                state_.graph.edges.push_back({from, pass, EdgeKind::after, kNoId, loc});
            }
            return;
        }
        const std::string who = "pass " + quoted(state_.pass_name(pass));
        Diagnostic& d = state_.pass_error(
            pass, loc, "W104",
            itself ? who + " can't run after itself" : who + " runs after unknown pass " + quoted(name));
        add_help(d, itself ? "leave it out" : did_you_mean_text(name, state_.pass_names()));
        add_help(d, itself ? "" : "passes are " + joined(state_.pass_names()));
    }

    void add_read(const Cell& cell, PassId writer, const CellUse& reader, bool pinnable) {
        add_arc({writer, reader.pass, EdgeKind::raw, cell.resource, use(reader).loc, pinnable});
    }

    void add_known(Cell& cell) {
        for (const CellUse& reader : cell.readers) {
            state_.spend(search_steps(cell), use(reader).loc);
            if (port(reader).pinned()) {
                add_pin(cell, reader);
            } else if (cell.writer_index(reader.pass) < 0) {
                const bool several = cell.writers.size() > 1;
                for (const CellUse& writer : cell.writers) add_read(cell, writer.pass, reader, several);
            }
        }
        for (const CellUse& writer : cell.writers) {
            state_.spend(search_steps(cell), use(writer).loc);
            if (port(writer).pinned()) add_pin(cell, writer);
        }
        add_repeats(cell);
        add_base(cell);
        cell.ordered = cell.writers.size() <= 1;
    }

    void add_pin(Cell& cell, const CellUse& reader) {
        bool writes_cell = false;
        state_.spend(port(reader).pins.size() * search_steps(cell), use(reader).loc);
        for (const PassId pin : visible_pins(port(reader), reader.pass)) {
            if (cell.writer_index(pin) < 0) continue;
            add_read(cell, pin, reader, false);
            writes_cell = true;
        }
        if (!writes_cell) cell.foreign_pins[reader];
    }

    // The passes of one repeat write one after the other.
    void add_repeats(const Cell& cell) {
        std::map<const PassDesc*, std::map<uint32_t, CellUse>> repeats;
        for (const CellUse& writer : cell.writers) {
            const PassWork& work = state_.passes[writer.pass];
            if (!work.indices.empty()) repeats[work.desc][work.instance] = writer;
        }
        for (const auto& [desc, writers] : repeats) {
            const CellUse* before = nullptr;
            for (const auto& [instance, writer] : writers) {
                if (before)
                    add_arc({before->pass, writer.pass, EdgeKind::waw, cell.resource, use(writer).loc});
                before = &writer;
            }
        }
    }

    // The one writer that starts a version, or of several that go on the one most like a start, comes first.
    void add_base(const Cell& cell) {
        if (cell.writers.size() < 2) return;
        const auto rank = [this](const CellUse& w) { return port(w).rank; };
        const auto base = std::ranges::min_element(cell.writers, {}, rank);
        if (rank(*base) == WriteRank::in_place || std::ranges::count(cell.writers, rank(*base), rank) != 1)
            return;
        for (const CellUse& writer : cell.writers) {
            const EdgeKind kind = EdgeKind::waw;
            add_arc({base->pass, writer.pass, kind, cell.resource, use(writer).loc});
        }
    }

    // x@p where p doesn't write x: the version of the last writer that isn't ordered after p.
    bool add_foreign_pins() {
        std::map<PassId, std::vector<uint8_t>> reached;
        bool any = false;
        for (Cell& cell : cells_) {
            for (auto& [reader, before] : cell.foreign_pins) {
                const std::vector<PassId>& pins = port(reader).pins;
                for (const PassId pin : pins) {
                    pay(use(reader).loc);
                    if (!reached.contains(pin)) reached.emplace(pin, order_.reached_from(pin));
                }
                state_.spend(pins.size() * cell.writers.size(), use(reader).loc);
                for (const CellUse& writer : cell.writers) {
                    const bool later = std::ranges::any_of(pins, [&](const PassId pin) {
                        return pin == writer.pass || reached.at(pin)[writer.pass];
                    });
                    if (writer.pass != reader.pass && !later) before.push_back(writer.pass);
                }
                any = true;
            }
        }
        if (!any) return true;
        for (const Cell& cell : cells_) {
            for (const auto& [reader, before] : cell.foreign_pins) {
                for (const PassId writer : before) add_read(cell, writer, reader, false);
            }
        }
        return sorted();
    }

    void sort_by_position(Cell& cell) const {
        std::ranges::sort(cell.writers, {}, [this](const CellUse& w) { return order_.position(w.pass); });
    }

    bool is_chain(const Cell& cell) {
        for (size_t i = 1; i < cell.writers.size(); ++i) {
            pay(use(cell.writers[i]).loc);
            if (!order_.reaches(cell.writers[i - 1].pass, cell.writers[i].pass)) return false;
        }
        return true;
    }

    bool order_writers() {
        std::vector<Cell*> fresh;  // ordered, but not yet used to order others
        std::vector<Cell*> pending;
        for (Cell& cell : cells_) (cell.ordered ? fresh : pending).push_back(&cell);
        while (true) {
            bool added = false;
            for (const Cell* cell : fresh) added |= add_overwrites(*cell);
            fresh.clear();
            if (added && !sorted()) return false;
            std::erase_if(pending, [&](Cell* cell) {
                state_.spend(cell->writers.size(), use(cell->writers.front()).loc);
                sort_by_position(*cell);
                cell->ordered = is_chain(*cell);
                if (cell->ordered) fresh.push_back(cell);
                return cell->ordered;
            });
            if (fresh.empty()) return true;
        }
    }

    bool add_overwrites(const Cell& cell) {
        bool added = false;
        const auto add = [&](const CellUse& reader) {
            const auto next = static_cast<size_t>(version_seen(state_, cell, reader) + 1);
            if (next >= cell.writers.size() || cell.writers[next].pass == reader.pass) return;
            add_arc({reader.pass, cell.writers[next].pass, EdgeKind::war, cell.resource,
                     use(cell.writers[next]).loc});
            added = true;
        };
        for (const CellUse& reader : cell.readers) add(reader);
        for (const CellUse& writer : cell.writers) {
            if (port(writer).pinned()) add(writer);
        }
        return added;
    }

    void report_pair(const Cell& cell, const CellUse& a, const CellUse& b) {
        const std::string range = quoted(range_of(state_.graph.resources[cell.resource], cell.range));
        const std::string& name_a = state_.author_name(std::min(a.pass, b.pass));
        const std::string& name_b = state_.author_name(std::max(a.pass, b.pass));
        const CellUse& later = a.pass > b.pass ? a : b;
        const CellUse& earlier = a.pass > b.pass ? b : a;
        Diagnostic& d = state_.error(use(later).loc, "W111",
                                     "passes " + quoted(name_a) + " and " + quoted(name_b) + " both write " +
                                         range + ", and nothing orders them");
        const Diagnostic place = state_.input.graph.sources.error(use(earlier).loc, "", "");
        if (place.line != 0) d.notes.push_back({place.file, place.line, place.column, "the other write"});
        add_help(d, "say which comes first: \"after\": [" + quoted(name_a) + "] in " + quoted(name_b) +
                        ", or the other way round");
        add_help(d, "or let one read the other's version: " +
                        quoted(state_.resource_name(cell.resource) + "@" + name_a) + " in " + quoted(name_b));
    }

    ResolveState& state_;
    std::vector<Cell>& cells_;
    PassOrder order_;
    uint64_t paid_ = 0;
};

// In place: the output's range overlaps an input of the same pass.
void find_in_place_writes(ResolveState& state) {
    for (PassId pass = 0; pass < state.passes.size(); ++pass) {
        const std::vector<UseDecl>& uses = state.graph.passes[pass].uses;
        for (size_t out = 0; out < uses.size(); ++out) {
            if (!writes(uses[out].access)) continue;
            for (const UseDecl& in : uses) {
                const bool seen = in.access != Access::none && !writes(in.access);
                if (seen && in.resource == uses[out].resource && overlaps(in.range, uses[out].range)) {
                    state.passes[pass].ports[out].rank = WriteRank::in_place;
                }
            }
        }
    }
}

}  // namespace

void resolve_versions(ResolveState& state) {
    find_in_place_writes(state);
    std::vector<Cell> cells = make_cells(state);
    VersionOrder order(state, cells);
    if (!order.run()) return;
    order.report_unordered();
    connect_versions(state, cells);
    check_turned_cells(state, cells);
}

}  // namespace weft
