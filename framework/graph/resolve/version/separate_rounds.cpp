#include <algorithm>
#include <set>
#include <tuple>

#include "graph/resolve/fault_text.h"
#include "graph/resolve/version/group_rounds.h"

namespace weft {
namespace {

class RoundSeparator {
 public:
    RoundSeparator(const Declared& declared, VersionedGraph& graph, Reporter& reporter)
        : declared_(declared),
          graph_(graph),
          report_(declared.shapes, declared.expansion, graph.suspects, reporter),
          reporter_(reporter) {}

    std::vector<Cell> run(const std::vector<Cell>& cells) {
        for (const Cell& cell : cells) add(cell);
        return std::move(separated_);
    }

 private:
    [[nodiscard]] const PassDraft& draft(PassId pass) const { return declared_.expansion.passes[pass]; }
    [[nodiscard]] UseDecl& use(const CellUse& u) { return graph_.passes[u.pass].uses[u.use]; }
    // Returns the name of the group that owns the resource; empty if the resource belongs to no group.
    [[nodiscard]] std::string owner(const Cell& cell) const {
        const ResourceDesc* desc = declared_.shapes.origins[cell.resource].desc;
        return desc != nullptr ? desc->group : "";
    }

    void add(const Cell& cell) {
        if (!owner(cell).empty()) return add_local(cell);
        const auto writer = std::ranges::find_if(
            cell.writers, [&](const CellUse& w) { return draft(w.pass).group != kNoId; });
        if (writer == cell.writers.end() || !check_writers(cell, *writer)) {
            separated_.push_back(cell);
            return;
        }
        Cell own = cell, others = cell;
        others.writers.clear();
        const auto elsewhere = [&](const CellUse& reader) {
            return in_other_round(draft(reader.pass), draft(writer->pass));
        };
        for (const CellUse& reader : own.readers) {
            if (use(reader).wakes || draft(reader.pass).group != draft(writer->pass).group) continue;
            use(reader).latest = true;
            own.before_round.insert(reader);
        }
        std::erase_if(own.readers, elsewhere);
        std::erase_if(others.readers, [&](const CellUse& reader) { return !elsewhere(reader); });
        separated_.push_back(std::move(own));
        if (others.readers.empty()) return;
        for (const CellUse& reader : others.readers) use(reader).latest = true;
        separated_.push_back(std::move(others));
    }

    // Divides a cell of a resource that belongs to a group into one cell for each round. An observer (a pass
    // that reads the resource back) reads the cell of the last round.
    void add_local(const Cell& cell) {
        const std::string group = owner(cell);
        std::map<uint32_t, Cell> rounds;
        const auto round = [&](uint32_t number) -> Cell& {
            Cell& found = rounds[number];
            found.resource = cell.resource;
            found.range = cell.range;
            return found;
        };
        for (const CellUse& writer : cell.writers) {
            if (draft(writer.pass).desc->group != group) return report_outside(cell, writer, group);
            round(draft(writer.pass).round).writers.push_back(writer);
        }
        const uint32_t last = rounds.empty() ? 0 : rounds.rbegin()->first;
        for (const CellUse& reader : cell.readers) {
            const bool inside = draft(reader.pass).desc->group == group;
            const bool observes = draft(reader.pass).is_observer || draft(reader.pass).desc->observes;
            if (!inside && !observes) return report_outside(cell, reader, group);
            if (!inside) use(reader).latest = true;
            round(inside ? draft(reader.pass).round : last).readers.push_back(reader);
        }
        for (auto& [number, part] : rounds) separated_.push_back(std::move(part));
    }

    // Checks that all writers of the cell (a part of a resource) belong to the round of `first`. Returns
    // false if one of them does not.
    bool check_writers(const Cell& cell, const CellUse& first) {
        for (const CellUse& writer : cell.writers) {
            const PassDraft& other = draft(writer.pass);
            if (other.decl.carries) continue;  // find_rest_units() reports this fault.
            if (other.group == draft(first.pass).group && other.round == draft(first.pass).round) continue;
            report_writers(cell, first, writer);
            return false;
        }
        return true;
    }

    // Marks the writers of the resource as suspect. Returns true if no error about this resource and the
    // descriptions of these two passes was reported yet.
    bool is_new(const Cell& cell, PassId a, PassId b) {
        graph_.suspects.writers[cell.resource] = 1;
        return reported_.insert({draft(a).desc, draft(b).desc, cell.resource}).second;
    }

    void report_writers(const Cell& cell, const CellUse& first, const CellUse& other) {
        if (!is_new(cell, first.pass, other.pass)) return;
        const PassDraft& a = draft(first.pass);
        const PassDraft& b = draft(other.pass);
        const std::string what = quote(range_of(graph_.resources[cell.resource], cell.range));
        const bool rounds = in_other_round(a, b);
        Diagnostic& d = report_.error(
            first.pass, use(first).loc, "W190",
            rounds ? "several rounds of group " + quote(a.desc->group) + " write " + what +
                         ", so its content would depend on the order in which the rounds run"
                   : "pass " + quote(a.desc->name) + " of group " + quote(a.desc->group) + " writes " + what +
                         ", and pass " + quote(b.desc->name) +
                         " writes this part, too, so its content would depend on which rounds run");
        if (rounds) {
            const std::string& index = draft(first.pass).desc->repeat.front().index;
            const bool image = graph_.resources[cell.resource].kind == ResourceKind::image;
            const std::string part =
                image ? ".layer(" + index + ")" : ".range(64*" + index + "..64*" + index + "+63)";
            add_help(d, std::string("let each round write ") + (image ? "a layer or mip" : "elements") +
                            " of its own, such as " + quote(declared_.resource_name(cell.resource) + part));
            add_help(d,
                     "or declare the resource in the \"resources\" of the group, if only one round needs "
                     "its content");
            return;
        }
        add_note(d, reporter_.sources(), use(other).loc, "the other pass writes here");
        add_help(d, "let the two passes write different resources, mips, layers or elements");
    }

    void report_outside(const Cell& cell, const CellUse& u, const std::string& group) {
        if (!is_new(cell, u.pass, u.pass)) return;
        Diagnostic& d =
            report_.error(u.pass, use(u).loc, "W190",
                          "pass " + quote(draft(u.pass).desc->name) + " uses " +
                              quote(declared_.resource_name(cell.resource)) + ", which belongs to group " +
                              quote(group) + " and has content only while a round runs");
        add_help(d,
                 "move the resource to the \"resources\" of the graph and add \"keep\": true; or move the "
                 "pass into the group");
    }

    const Declared& declared_;
    VersionedGraph& graph_;
    std::vector<Cell> separated_;
    std::set<std::tuple<const PassDesc*, const PassDesc*, ResourceId>> reported_;
    PassReporter report_;
    Reporter& reporter_;
};

}  // namespace

std::vector<Cell> separate_rounds(const Declared& declared, std::vector<Cell> cells, VersionedGraph& graph,
                                  Reporter& reporter) {
    if (declared.expansion.groups.empty()) return cells;
    return RoundSeparator(declared, graph, reporter).run(cells);
}

}  // namespace weft
