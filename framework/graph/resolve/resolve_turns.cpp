// Passes that take turns, one a frame: what they write must still be there in the frames between, and every
// read must see the version that it names in each frame, whichever passes run in it.
#include <algorithm>
#include <set>
#include <tuple>

#include "graph/resolve/resolve_sources.h"

namespace weft {
namespace {

bool stays(const ResourceDecl& resource) {
    return resource.lifetime == ResourceLifetime::persistent && resource.history == 0;
}

void check_repeat(ResolveState& state, const PassDesc& desc) {
    const bool none = desc.per_frame.empty() || desc.per_frame.text == "false";
    if (none || !desc.repeat.empty()) return;
    Diagnostic& d = state.error(desc.per_frame_loc, "W124",
                                "pass " + quoted(desc.name) + " says \"perFrame\" but repeats nothing");
    add_help(d, "say what takes turns: \"repeat\": { \"i\": \"0..5\" }");
}

void check_outputs(ResolveState& state, PassId pass) {
    const IndexScope scope(state, pass);
    for (const UseDecl& use : state.graph.passes[pass].uses) {
        const ResourceDecl& resource = state.graph.resources[use.resource];
        if (!writes(use.access) || stays(resource)) continue;
        Diagnostic& d =
            state.pass_error(pass, use.loc, "W124",
                             "pass " + quoted(state.author_name(pass)) + " writes a part of " +
                                 quoted(resource.name) + " each frame, but its content does not stay");
        if (resource.lifetime == ResourceLifetime::imported)
            add_help(d, "write a resource with \"keep\": true, and copy that");
        else
            add_help(d, "add \"keep\": true to resource " + quoted(resource.name) +
                            (resource.history > 0 ? " instead of its history" : ""));
    }
}

// Passes of one turn run in the same frames. A pass without turns, or with a single one, runs in all of them.
struct Turn {
    uint32_t count = 1;
    uint32_t index = 0;
    bool operator==(const Turn&) const = default;
};

Turn turn_of(const ResolveState& state, PassId pass) {
    const PassDecl& decl = state.graph.passes[pass];
    return decl.turns > 1 ? Turn{decl.turns, decl.turn} : Turn{};
}

// Judges the reads of one cell. Any set of turns may be chosen in a frame, so the rule does not ask when a
// turn comes: a read is right in every frame if
// - the pass whose version it names runs in each frame in which the reader does, or
// - that version is the last one of the cell, and all of the cell's writers run in the same frames, or
// - every writer changes what is there: then each read sees the content as it stands, which is what it names.
class TurnedCell {
 public:
    using Reported = std::set<std::tuple<const PassDesc*, const PassDesc*, ResourceId>>;

    TurnedCell(ResolveState& state, const Cell& cell, Reported& reported)
        : state_(state), cell_(cell), reported_(reported) {}

    void check() {
        const auto takes_turns = [&](const CellUse& w) { return turn_of(state_, w.pass) != Turn{}; };
        if (!cell_.ordered || std::ranges::none_of(cell_.writers, takes_turns)) return;
        const auto changes = [&](const CellUse& w) { return source_of(w) != nullptr; };
        if (std::ranges::all_of(cell_.writers, changes)) return;
        for (const CellUse& reader : cell_.readers) check_read(reader);
        for (const CellUse& writer : cell_.writers) check_read(writer);
    }

 private:
    const UseDecl& use(const CellUse& u) const { return state_.graph.passes[u.pass].uses[u.use]; }

    // Null: it does not see what was there.
    const VersionSource* source_of(const CellUse& u) const {
        const std::vector<VersionSource>& sources = use(u).sources;
        const auto found = std::ranges::find_if(
            sources, [&](const VersionSource& s) { return overlaps(s.range, cell_.range); });
        return found == sources.end() ? nullptr : &*found;
    }

    void check_read(const CellUse& reader) {
        const VersionSource* source = source_of(reader);
        if (source == nullptr) return;
        const bool before = source->producer == kNoId;  // what the last writer left in the frame before
        const size_t version =
            before ? cell_.writers.size() - 1 : static_cast<size_t>(cell_.writer_index(source->producer));
        const CellUse& wanted = cell_.writers[version];
        const Turn turn = turn_of(state_, wanted.pass);
        if (turn == Turn{} || (!before && turn == turn_of(state_, reader.pass))) return;
        const auto other = std::ranges::find_if(
            cell_.writers, [&](const CellUse& w) { return turn_of(state_, w.pass) != turn; });
        if (other != cell_.writers.end()) return report(reader, wanted, *other);
        if (version + 1 < cell_.writers.size()) report(reader, wanted, cell_.writers[version + 1]);
    }

    void report(const CellUse& reader, const CellUse& wanted, const CellUse& other) {
        const auto desc = [&](const CellUse& u) { return state_.passes[u.pass].desc; };
        if (!reported_.insert({desc(reader), desc(wanted), cell_.resource}).second) return;
        const ResourceDecl& resource = state_.graph.resources[cell_.resource];
        const std::string what = quoted(range_of(resource, cell_.range));
        const std::string who = state_.observers.contains(state_.pass_name(reader.pass))
                                    ? "the observer"
                                    : "pass " + quoted(state_.pass_name(reader.pass));
        Diagnostic& d = state_.pass_error(reader.pass, use(reader).loc, "W124",
                                          who + " reads what pass " + quoted(state_.pass_name(wanted.pass)) +
                                              " wrote into " + what +
                                              ", but in frames in which that pass does not run, pass " +
                                              quoted(state_.pass_name(other.pass)) + " has overwritten it");
        const Diagnostic place = state_.input.graph.sources.error(use(other).loc, "", "");
        if (place.line != 0) d.notes.push_back({place.file, place.line, place.column, "the other write"});
        if (resource.kind == ResourceKind::image)
            add_help(d, "let each round write a layer or mip of its own, and read that: " +
                            quoted(resource.name + ".layer(i)"));
        add_help(d, "or, where each round changes only its own part of what is there, say \"partial\": true");
        add_help(d, "or run all rounds in every frame: remove \"perFrame\" from " +
                        quoted(state_.author_name(wanted.pass)));
    }

    ResolveState& state_;
    const Cell& cell_;
    Reported& reported_;
};

}  // namespace

void check_turned_cells(ResolveState& state, const std::vector<Cell>& cells) {
    TurnedCell::Reported reported;
    for (const Cell& cell : cells) TurnedCell(state, cell, reported).check();
}

void check_turns(ResolveState& state) {
    for (const auto& [name, desc] : state.input.graph.passes) check_repeat(state, desc);
    for (PassId id = 0; id < state.passes.size(); ++id)
        if (state.graph.passes[id].turns > 0) check_outputs(state, id);
}

}  // namespace weft
