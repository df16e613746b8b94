#include "graph/resolve/version/order_writers.h"

#include <algorithm>
#include <set>

#include "graph/resolve/fault_text.h"
#include "graph/resolve/version/connect_versions.h"
#include "graph/resolve/version/pass_order.h"

namespace weft {
namespace {

// Finds the order of the passes that write each cell. A cell is a part of a resource that every use covers
// completely or not at all. First adds the arcs ("pass A runs before pass B") that follow directly from the
// graph file, for example from `after`, from references with `@pass`, and from reads that must follow all
// writers. Then sorts the writers of each cell by these arcs. Each sorted cell gives new arcs, because the
// readers of a version run before the next writer. The new arcs may order the writers of other cells, so this
// step is repeated until no further cell can be sorted. If two writers of a cell still have no order, that is
// error W111. A cycle is error W150.
class WriterOrder {
 public:
    WriterOrder(const Declared& declared, VersionedGraph& graph, std::vector<Cell>& cells, Reporter& reporter)
        : declared_(declared),
          graph_(graph),
          cells_(cells),
          report_(declared.shapes, declared.expansion, graph.suspects, reporter),
          reporter_(reporter),
          order_(graph.passes.size()) {}

    // Orders the writers of all cells. Returns false if there is a cycle; then versions are undefined.
    bool run() {
        add_after();
        for (Cell& cell : cells_) add_known(cell);
        if (!sort()) return false;
        if (!add_foreign_pins()) return false;
        return order_all();
    }

    void report_unordered() {
        std::set<std::pair<const PassDesc*, const PassDesc*>> reported;
        for (Cell& cell : cells_) {
            if (cell.ordered || graph_.suspects.writers[cell.resource]) continue;
            sort_by_position(cell);
            for (size_t i = 1; i < cell.writers.size(); ++i) {
                const PassId a = cell.writers[i - 1].pass;
                const PassId b = cell.writers[i].pass;
                pay(use(cell.writers[i]).loc);
                if (order_.reaches(a, b)) continue;
                if (reported.insert(std::minmax(drafts()[a].desc, drafts()[b].desc)).second)
                    report_pair(cell, cell.writers[i - 1], cell.writers[i]);
            }
        }
    }

 private:
    const UseDecl& use(const CellUse& u) const { return graph_.passes[u.pass].uses[u.use]; }
    const PortDraft& port(const CellUse& u) const { return graph_.passes[u.pass].ports[u.use]; }

    const std::vector<PassDraft>& drafts() const { return declared_.expansion.passes; }

    // Counts the steps that searches of the pass order have taken since the last call.
    void pay(SourceLoc loc) {
        reporter_.spend(order_.work() - paid_, loc);
        paid_ = order_.work();
    }

    // Returns the number of steps that are counted for finding one writer of a cell. One step covers 64
    // comparisons, because a comparison is fast.
    static uint64_t search_steps(const Cell& cell) {
        constexpr size_t kWritersPerStep = 64;
        return 1 + cell.writers.size() / kWritersPerStep;
    }

    // Adds an arc to the order. Storing an arc costs more time and memory than visiting one, so it counts as
    // several steps.
    void add_arc(const OrderArc& arc) {
        constexpr uint64_t kStepsPerArc = 4;
        reporter_.spend(kStepsPerArc, arc.loc);
        order_.add(arc);
    }

    bool sort() {
        pay(drafts().empty() ? SourceLoc{} : drafts().front().desc->loc);
        if (order_.sort()) return true;
        report_cycles(declared_, graph_, order_, reporter_);
        return false;
    }

    void add_after() {
        for (PassId pass(0); pass < drafts().size(); ++pass) {
            const PassDesc& desc = *drafts()[pass].desc;
            for (size_t i = 0; i < desc.after.size(); ++i) {
                const SourceLoc loc = i < desc.after_locs.size() ? desc.after_locs[i] : desc.loc;
                add_after(pass, desc.after[i], loc);
            }
        }
    }

    void add_after(PassId pass, const std::string& name, SourceLoc loc) {
        const auto found = declared_.expansion.instances.find(name);
        const bool itself = name == declared_.author_name(pass);
        if (found != declared_.expansion.instances.end() && !itself) {
            for (const PassId from : found->second) {
                if (in_other_round(drafts()[from], drafts()[pass])) continue;
                const EdgeDecl edge{from, pass, EdgeKind::after, kNoId, loc};
                add_arc({edge});
                graph_.edges.push_back(edge);
            }
            return;
        }
        const std::string who = "pass " + quote(declared_.pass_name(pass));
        Diagnostic& d = report_.error(
            pass, loc, "W104",
            itself ? who + " cannot run after itself" : who + " runs after unknown pass " + quote(name));
        add_help(d, itself ? "remove its own name from \"after\""
                           : did_you_mean_text(name, list_pass_names(declared_.input.graph)));
        add_help(d, itself ? "" : "the passes are " + quote_all(list_pass_names(declared_.input.graph)));
    }

    void add_read(const Cell& cell, PassId writer, const CellUse& reader, bool pinnable) {
        add_arc({{writer, reader.pass, EdgeKind::raw, cell.resource, use(reader).loc}, pinnable});
    }

    void add_known(Cell& cell) {
        for (const CellUse& reader : cell.readers) {
            reporter_.spend(search_steps(cell), use(reader).loc);
            if (cell.before_round.contains(reader)) continue;
            if (port(reader).pinned()) {
                add_pin(cell, reader);
            } else if (cell.writer_index(reader.pass) < 0) {
                const bool several = cell.writers.size() > 1;
                for (const CellUse& writer : cell.writers) add_read(cell, writer.pass, reader, several);
            }
        }
        for (const CellUse& writer : cell.writers) {
            reporter_.spend(search_steps(cell), use(writer).loc);
            if (port(writer).pinned()) add_pin(cell, writer);
        }
        add_repeats(cell);
        add_base(cell);
        cell.ordered = cell.writers.size() <= 1;
    }

    void add_pin(Cell& cell, const CellUse& reader) {
        bool writes_cell = false;
        reporter_.spend(port(reader).pins.size() * search_steps(cell), use(reader).loc);
        for (const PassId pin : visible_pins(port(reader), reader.pass)) {
            if (cell.writer_index(pin) < 0) continue;
            add_read(cell, pin, reader, false);
            writes_cell = true;
        }
        if (!writes_cell) cell.foreign_pins[reader];
    }

    // Adds arcs ("from" runs before "to") between the passes of one repeat that write the cell (a part of a
    // resource), so that these passes run one after the other.
    void add_repeats(const Cell& cell) {
        std::map<const PassDesc*, std::map<uint32_t, CellUse>> repeats;
        for (const CellUse& writer : cell.writers) {
            const PassDraft& draft = drafts()[writer.pass];
            if (!draft.indices.empty()) repeats[draft.desc][draft.instance] = writer;
        }
        for (const auto& [desc, writers] : repeats) {
            const CellUse* before = nullptr;
            for (const auto& [instance, writer] : writers) {
                if (before)
                    add_arc({{before->pass, writer.pass, EdgeKind::waw, cell.resource, use(writer).loc}});
                before = &writer;
            }
        }
    }

    // If exactly one writer of the cell (a part of a resource) replaces all content (WriteRank::fresh), adds
    // arcs so that this writer runs before all other writers. If no writer replaces all content, but exactly
    // one can start without an earlier version (WriteRank::resumes), adds such arcs for that writer.
    void add_base(const Cell& cell) {
        if (cell.writers.size() < 2) return;
        // A carry pass (it copies content of the last frame) runs before all other writers. One of the other
        // writers may in turn have to run before the rest of them.
        std::vector<CellUse> writers = cell.writers;
        const auto carries = [this](const CellUse& w) { return drafts()[w.pass].decl.carries; };
        if (const auto carry = std::ranges::find_if(writers, carries); carry != writers.end()) {
            add_first(cell, carry->pass, writers);
            writers.erase(carry);
        }
        const auto rank = [this](const CellUse& w) { return port(w).rank; };
        // If exactly one pass without a switch replaces all content of the cell, this pass runs first. The
        // passes with a switch run after it and change the content that it wrote.
        const auto always_fresh = [&](const CellUse& w) {
            return drafts()[w.pass].decl.switch_id == kNoId && rank(w) == WriteRank::fresh;
        };
        if (std::ranges::count_if(writers, always_fresh) == 1)
            return add_first(cell, std::ranges::find_if(writers, always_fresh)->pass, writers);
        const auto base = std::ranges::min_element(writers, {}, rank);
        if (rank(*base) == WriteRank::in_place || std::ranges::count(writers, rank(*base), rank) != 1) return;
        add_first(cell, base->pass, writers);
    }

    // Adds arcs so that the pass `first` runs before all other writers in `writers`.
    void add_first(const Cell& cell, PassId first, const std::vector<CellUse>& writers) {
        for (const CellUse& writer : writers)
            if (writer.pass != first)
                add_arc({{first, writer.pass, EdgeKind::waw, cell.resource, use(writer).loc}});
    }

    // Resolves references x@p where pass p does not write x. The reference means the version of the last
    // writer of x that does not run after p, so the reader runs after all such writers. Returns false if this
    // causes a cycle.
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
                reporter_.spend(pins.size() * cell.writers.size(), use(reader).loc);
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
        return sort();
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

    bool order_all() {
        // Cells (parts of resources) whose writers are ordered, but whose order has not yet been used to
        // order other passes.
        std::vector<Cell*> fresh;
        std::vector<Cell*> pending;
        for (Cell& cell : cells_) (cell.ordered ? fresh : pending).push_back(&cell);
        while (true) {
            bool added = false;
            for (const Cell* cell : fresh) added |= add_overwrites(*cell);
            fresh.clear();
            if (added && !sort()) return false;
            std::erase_if(pending, [&](Cell* cell) {
                reporter_.spend(cell->writers.size(), use(cell->writers.front()).loc);
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
            const auto next = static_cast<size_t>(version_seen(graph_, cell, reader) + 1);
            if (next >= cell.writers.size() || cell.writers[next].pass == reader.pass) return;
            add_arc({{reader.pass, cell.writers[next].pass, EdgeKind::war, cell.resource,
                      use(cell.writers[next]).loc}});
            added = true;
        };
        for (const CellUse& reader : cell.readers) add(reader);
        for (const CellUse& writer : cell.writers) {
            if (port(writer).pinned()) add(writer);
        }
        return added;
    }

    void report_pair(const Cell& cell, const CellUse& a, const CellUse& b) {
        const std::string range = quote(range_of(graph_.resources[cell.resource], cell.range));
        const std::string& name_a = declared_.author_name(std::min(a.pass, b.pass));
        const std::string& name_b = declared_.author_name(std::max(a.pass, b.pass));
        const CellUse& later = a.pass > b.pass ? a : b;
        const CellUse& earlier = a.pass > b.pass ? b : a;
        Diagnostic& d = reporter_.error(use(later).loc, "W111",
                                        "passes " + quote(name_a) + " and " + quote(name_b) + " both write " +
                                            range + ", but nothing determines their order");
        add_note(d, reporter_.sources(), use(earlier).loc, "the other pass writes here");
        add_help(d, "define the order: add \"after\": [" + quote(name_a) + "] to " + quote(name_b) +
                        ", or add \"after\": [" + quote(name_b) + "] to " + quote(name_a));
        add_help(d, "or let pass " + quote(name_b) + " read the result of " + quote(name_a) + ": " +
                        quote(declared_.resource_name(cell.resource) + "@" + name_a));
    }

    const Declared& declared_;
    VersionedGraph& graph_;
    std::vector<Cell>& cells_;
    PassReporter report_;
    Reporter& reporter_;
    PassOrder order_;
    uint64_t paid_ = 0;
};

}  // namespace

bool order_writers(const Declared& declared, VersionedGraph& graph, std::vector<Cell>& cells,
                   Reporter& reporter) {
    WriterOrder order(declared, graph, cells, reporter);
    if (!order.run()) return false;
    order.report_unordered();
    return true;
}

}  // namespace weft
