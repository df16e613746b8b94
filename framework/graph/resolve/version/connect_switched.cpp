// A pass with "switch" does not run in some frames. In these frames, it writes nothing, and the readers of
// its version of a resource see the version before that version.
#include <algorithm>
#include <map>

#include "graph/resolve/fault_text.h"
#include "graph/resolve/switches/switches_text.h"
#include "graph/resolve/version/cell_stage.h"
#include "graph/resolve/version/connect_versions.h"

namespace weft {
namespace {

class SwitchConnector : CellStage {
 public:
    using CellStage::CellStage;

    void run() {
        const size_t known = reporter_.error_count();
        for (const Cell& cell : cells_) {
            const bool any = std::ranges::any_of(cell.writers, [&](const CellUse& w) { return switched(w); });
            if (!any || !cell.ordered || graph_.suspects.writers[cell.resource]) continue;
            connect(cell);
        }
        for (const auto& [u, versions] : passed_on_) use(u).passes_on = merge_sources(versions);
        reporter_.sort_errors(known);
    }

 private:
    // Where the content of a version comes from in one combination of the switches.
    enum class Origin : uint8_t { this_frame, before_frame, nothing };

    [[nodiscard]] const PassDraft& draft(PassId pass) const { return declared_.expansion.passes[pass]; }
    [[nodiscard]] bool switched(const CellUse& u) const { return draft(u.pass).decl.switch_id != kNoId; }
    [[nodiscard]] bool has_content(const Cell& cell) const {
        return declared_.shapes.origins[cell.resource].has_content;
    }

    void connect(const Cell& cell) {
        for (size_t i = 0; i < cell.writers.size(); ++i) {
            const CellUse& writer = cell.writers[i];
            reporter_.spend(1, use(writer).loc);
            if (!switched(writer)) continue;
            check_slices(cell, writer);
            if (i > 0)
                passed_on_[writer].push_back({cell.range, cell.writers[i - 1].pass});
            else if (has_content(cell))
                passed_on_[writer].push_back({cell.range, kNoId});
        }
        for (const CellUse& reader : cell.readers) check_read(cell, reader);
        for (const CellUse& writer : cell.writers)
            if (sees(writer, cell)) check_read(cell, writer);
        check_end_of_frame(cell);
    }

    // Returns true if the write needs the content of the previous version.
    bool sees(const CellUse& writer, const Cell& cell) {
        return std::ranges::any_of(use(writer).sources, [&](const VersionSource& source) {
            return overlaps(source.range, cell.range);
        });
    }

    // Finds the origin of the content of a version: its writer or, if that is off, the last earlier writer
    // that runs. If `counts_carries` is false, content from before the frame does not count, even if a carry
    // pass copies it.
    [[nodiscard]] Origin origin(const Cell& cell, int version, Combination combination,
                                bool counts_carries = true) const {
        for (; version >= 0; --version) {
            const PassDecl& writer = draft(cell.writers[static_cast<size_t>(version)].pass).decl;
            if (writer.carries && !counts_carries) break;
            if (has_combination(writer.runs_in, combination)) return Origin::this_frame;
        }
        return has_content(cell) && counts_carries ? Origin::before_frame : Origin::nothing;
    }

    void check_read(const Cell& cell, const CellUse& reader) {
        const int version = version_seen(graph_, cell, reader);
        if (version < 0) return;  // The read means the content from before the frame.
        CombinationSet absent = 0;
        for (Combination c = 0; c < kCombinationCount; ++c) {
            if (!has_combination(use(reader).used_in & draft(reader.pass).decl.runs_in, c)) continue;
            const Origin found = origin(cell, version, c);
            const auto bit = static_cast<CombinationSet>(1u << c);
            if (found == Origin::nothing) absent |= bit;
            if (found == Origin::before_frame && graph_.resources[cell.resource].ring != kNoId)
                graph_.passes[reader.pass].ports[reader.use].valid_in &= complement(bit);
        }
        if (absent != 0) report_absent(cell, reader, version, absent);
    }

    void report_absent(const Cell& cell, const CellUse& reader, int version, CombinationSet absent) {
        if (graph_.suspects.uses[reader.pass][reader.use]) return;
        const PassId writer = cell.writers[static_cast<size_t>(version)].pass;
        const std::string what = quote(range_of(graph_.resources[cell.resource], cell.range));
        const bool modifies = writes(use(reader).access);
        Diagnostic& d = report_.error(
            reader.pass, use(reader).loc, "W234",
            name_reader(draft(reader.pass)) + (modifies ? " modifies " : " reads ") + what + " after pass " +
                quote(declared_.pass_name(writer)) + ", but in frames in which " +
                switches_text(declared_.expansion.switches, absent) + ", this content does not exist");
        add_help(d, "let a pass that always runs write all of " + what +
                        " before, for example a pass of type "
                        "\"clear\"");
        add_help(d, "or turn both passes off together: give them the same \"switch\"");
        if (!modifies && draft(reader.pass).shader)
            add_help(d, "or name a replacement with \"else\", or make the port \"optional\": true");
    }

    // Checks that a cell (a part of a resource) has content at the end of each frame, if the resource must
    // have content at that time. This applies to the output, to other imports whose old content is dropped,
    // and to resources with history.
    void check_end_of_frame(const Cell& cell) {
        const ResourceDecl& resource = graph_.resources[cell.resource];
        const bool import = resource.lifetime == ResourceLifetime::imported && !has_content(cell);
        if (!import && resource.history == 0) return;
        CombinationSet absent = 0;
        const int last = static_cast<int>(cell.writers.size()) - 1;
        for (Combination c = 0; c < kCombinationCount; ++c)
            if (origin(cell, last, c, import) == Origin::nothing)
                absent |= static_cast<CombinationSet>(1u << c);
        if (absent == 0) return;
        const auto writer = std::ranges::find_if(cell.writers, [&](const CellUse& w) { return switched(w); });
        const std::string what = quote(range_of(resource, cell.range));
        Diagnostic& d =
            report_.error(writer->pass, use(*writer).loc, "W234",
                          "pass " + quote(declared_.pass_name(writer->pass)) + " writes " + what +
                              ", which " + (import ? "the program reads after each frame" : "has history") +
                              ", but in frames in which " +
                              switches_text(declared_.expansion.switches, absent) + ", no pass writes it");
        add_help(d, "let a pass that always runs write all of " + what + " before this pass");
        if (!import)
            add_help(d, "or write another resource that has \"keep\": no pass has to write it in each frame");
    }

    void check_slices(const Cell& cell, const CellUse& writer) {
        const auto sliced = std::ranges::find_if(
            cell.writers, [&](const CellUse& w) { return draft(w.pass).decl.frame_slices > 1; });
        if (sliced == cell.writers.end()) return;
        Diagnostic& d = report_.error(
            writer.pass, use(writer).loc, "W235",
            "pass " + quote(declared_.pass_name(writer.pass)) + " with \"switch\" writes " +
                quote(range_of(graph_.resources[cell.resource], cell.range)) + ", and so does pass " +
                quote(declared_.pass_name(sliced->pass)) + " with \"perFrame\"");
        add_help(d, "let one of the two passes write another resource");
    }

    // For each write of a pass with a switch: the previous version in each cell.
    std::map<CellUse, std::vector<VersionSource>> passed_on_;
};

}  // namespace

void connect_switched(const Declared& declared, const std::vector<Cell>& cells, VersionedGraph& graph,
                      Reporter& reporter) {
    if (!declared.expansion.switches.empty()) SwitchConnector(declared, cells, graph, reporter).run();
}

}  // namespace weft
