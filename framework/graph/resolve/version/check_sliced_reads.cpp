// Checks the reads of resources that passes with `perFrame` write. Such a pass runs only in some frames. But
// in every frame, a read must see the version that its reference names, whichever passes run in that frame.
#include <algorithm>
#include <set>
#include <tuple>

#include "graph/resolve/fault_text.h"
#include "graph/resolve/version/connect_versions.h"

namespace weft {
namespace {

// The frames in which a pass with `perFrame` runs: frame 0, and each frame f with f mod count = index. A pass
// that runs in every frame has count 1.
struct FrameSlice {
    uint32_t count = 1;
    uint32_t index = 0;
    bool operator==(const FrameSlice&) const = default;
};

FrameSlice slice_of(const Declared& declared, PassId pass) {
    const PassDecl& decl = declared.expansion.passes[pass].decl;
    return decl.frame_slices > 1 ? FrameSlice{decl.frame_slices, decl.frame_slice} : FrameSlice{};
}

// Checks the reads of one cell. A cell is a part of a resource that every use covers completely or not at
// all. The writers of the cell may have different frame slices. The frame slice of a pass is the set of
// frames in which the pass runs. A read is right in every frame if one of these conditions holds:
// - The pass whose version the read names runs in every frame in which the reader runs. If the read means
//   content of the previous frame, that pass must run in every frame.
// - The named version is the last one of the cell, and all writers of the cell run in the same frames.
// - Every writer modifies the content in place. Then there is only one content, and every read means its
//   newest state.
class SlicedCell {
 public:
    using Reported = std::set<std::tuple<const PassDesc*, const PassDesc*, ResourceId>>;

    SlicedCell(const Declared& declared, const VersionedGraph& graph, const Cell& cell, Reported& reported,
               PassReporter& report, Reporter& reporter)
        : declared_(declared),
          graph_(graph),
          cell_(cell),
          reported_(reported),
          report_(report),
          reporter_(reporter) {}

    void check() {
        const auto is_sliced = [&](const CellUse& w) { return slice_of(declared_, w.pass) != FrameSlice{}; };
        if (!cell_.ordered || std::ranges::none_of(cell_.writers, is_sliced)) return;
        // check_frame_slices() has reported an error if a pass with `perFrame` writes a resource with
        // history.
        if (graph_.resources[cell_.resource].history > 0) return;
        const auto changes = [&](const CellUse& w) { return source_of(w) != nullptr; };
        if (std::ranges::all_of(cell_.writers, changes)) return;
        for (const CellUse& reader : cell_.readers) check_read(reader);
        for (const CellUse& writer : cell_.writers) check_read(writer);
    }

 private:
    const UseDecl& use(const CellUse& u) const { return graph_.passes[u.pass].uses[u.use]; }

    // Returns the version that the use sees in this cell (a part of the resource), or null if the use sees no
    // earlier content.
    const VersionSource* source_of(const CellUse& u) const {
        const std::vector<VersionSource>& sources = use(u).sources;
        const auto found = std::ranges::find_if(
            sources, [&](const VersionSource& s) { return overlaps(s.range, cell_.range); });
        return found == sources.end() ? nullptr : &*found;
    }

    void check_read(const CellUse& reader) {
        const VersionSource* source = source_of(reader);
        if (source == nullptr) return;
        // True if the read sees the content that the last writer left in the previous frame.
        const bool before = source->producer == kNoId;
        const size_t version =
            before ? cell_.writers.size() - 1 : static_cast<size_t>(cell_.writer_index(source->producer));
        const CellUse& wanted = cell_.writers[version];
        const FrameSlice slice = slice_of(declared_, wanted.pass);
        if (slice == FrameSlice{} || (!before && slice == slice_of(declared_, reader.pass))) return;
        const auto other = std::ranges::find_if(
            cell_.writers, [&](const CellUse& w) { return slice_of(declared_, w.pass) != slice; });
        if (other != cell_.writers.end()) return report(reader, wanted, *other);
        if (version + 1 < cell_.writers.size()) report(reader, wanted, cell_.writers[version + 1]);
    }

    void report(const CellUse& reader, const CellUse& wanted, const CellUse& other) {
        const auto desc = [&](const CellUse& u) { return declared_.expansion.passes[u.pass].desc; };
        if (!reported_.insert({desc(reader), desc(wanted), cell_.resource}).second) return;
        const ResourceDecl& resource = graph_.resources[cell_.resource];
        const std::string what = quote(range_of(resource, cell_.range));
        const std::string who = name_reader(declared_.expansion.passes[reader.pass]);
        Diagnostic& d =
            report_.error(reader.pass, use(reader).loc, "W124",
                          who + " reads " + what + " as pass " + quote(declared_.pass_name(wanted.pass)) +
                              " wrote it, but in frames without that pass, pass " +
                              quote(declared_.pass_name(other.pass)) + " has overwritten this content");
        add_note(d, reporter_.sources(), use(other).loc, "the other pass writes here");
        add_help(d, resource.kind == ResourceKind::image
                        ? "let each iteration write its own layer or mip, and read this part: " +
                              quote(resource.name + ".layer(i)")
                        : "let each iteration write its own elements, and read this part: " +
                              quote(resource.name + ".range(64*i..64*i+63)"));
        add_help(d, "or add \"partial\": true, if each iteration changes only its own part of the content");
        add_help(d, "or run all iterations in every frame: remove \"perFrame\" from " +
                        quote(declared_.author_name(wanted.pass)));
    }

    const Declared& declared_;
    const VersionedGraph& graph_;
    const Cell& cell_;
    Reported& reported_;
    PassReporter& report_;
    Reporter& reporter_;
};

}  // namespace

void check_sliced_reads(const Declared& declared, const std::vector<Cell>& cells, VersionedGraph& graph,
                        Reporter& reporter) {
    PassReporter report(declared.shapes, declared.expansion, graph.suspects, reporter);
    SlicedCell::Reported reported;
    for (const Cell& cell : cells) SlicedCell(declared, graph, cell, reported, report, reporter).check();
}

}  // namespace weft
