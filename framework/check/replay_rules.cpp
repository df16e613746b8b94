// Checks each simulated access: order, visibility, layout, content, and exclusive use of memory.
#include <algorithm>

#include "check/replay.h"

namespace weft::check {

bool Replay::ordered(const AccessRecord& record, StageMask stages) const {
    if (covered(record)) return true;
    return record.actor().queue == clock_.queue() && record.ordered_before(stages);
}

// Returns true if the barrier waits for the recorded access. If a semaphore already orders the access, the
// barrier must chain with the semaphore wait. The wait blocks all stages, so any non-empty source scope
// chains with it.
bool Replay::ordered(const AccessRecord& record, const Scopes& scopes) const {
    if (covered(record)) return scopes.src_execution != 0;
    return record.actor().queue == clock_.queue() && record.ordered_before(scopes);
}

bool Replay::flushed(const AccessRecord& record, const Scopes& scopes) const {
    if (!record.is_write() || covered(record)) return true;
    return record.actor().queue == clock_.queue() &&
           (record.available_before(scopes) || (record.stages() != 0 && record.flushed_by(scopes)));
}

bool Replay::flushed(const AccessRecord& record, StageMask stages) const {
    if (!record.is_write() || covered(record)) return true;
    return record.actor().queue == clock_.queue() && record.available_before(stages);
}

bool Replay::visible(const AccessRecord& record, const AccessState& state) const {
    return covered(record) || record.visible_to(state.stages, state.access);
}

std::string Replay::missing(const AccessRecord& record, const std::string& barrier) const {
    if (record.actor().queue == clock_.queue()) return barrier;
    return "queue " + std::to_string(clock_.queue()) + " must wait for queue " +
           std::to_string(record.actor().queue) + " after that pass";
}

void Replay::expect_order(const Actor& by, const UseDecl& use, Cell& cell, const AccessState& state,
                          bool is_write) {
    if (cell.has_write) follow(cell.write);
    const bool judged_as_read = is_write && reads(use.access);
    // The texts are built in lambdas, only for errors, because this function runs for every subresource of
    // every use.
    const auto who = [&] { return faults_.actor_text(by, frame_); };
    const auto what = [&] { return faults_.part_name(use.resource, cell.range); };
    const bool image = plan_.graph.resources[use.resource].kind == ResourceKind::image;
    if (image && !judged_as_read && cell.layout != state.layout)
        faults_.add("C320", use.loc,
                    who() + " needs " + what() + " in layout " + layout_text(state.layout) + ", but " +
                        faults_.actor_text(cell.has_write ? cell.write.actor() : Actor{}, frame_) +
                        " left it in layout " + layout_text(cell.layout),
                    "a barrier before " + who() + " must change the layout");
    // The rasteriser keeps the order of draws within one rendering scope, so these draws need no barrier.
    const auto drawn_before = [&](const AccessRecord& record) {
        return by.scope != 0 && record.actor().scope == by.scope;
    };
    if (cell.has_write && !judged_as_read && !drawn_before(cell.write) &&
        (!ordered(cell.write, state.stages) || !visible(cell.write, state))) {
        faults_.add(is_write ? "C312" : "C310", use.loc,
                    who() + (is_write ? " writes " : " reads ") + what() + " (" + access_text(state.access) +
                        " in " + stages_text(state.stages) + "), but the write by " +
                        faults_.actor_text(cell.write.actor(), frame_) + " (" +
                        access_text(cell.write.access()) + " in " + stages_text(cell.write.stages()) +
                        ") is not made visible first",
                    missing(cell.write, "a barrier between them is missing, or it lacks stages or accesses"));
    }
    if (!is_write) return;
    for (AccessRecord& record : cell.reads) {
        follow(record);
        if (drawn_before(record) || ordered(record, state.stages)) continue;
        faults_.add(
            "C311", use.loc,
            who() + " writes " + what() + " while " + faults_.actor_text(record.actor(), frame_) +
                " may still read it (" + stages_text(record.stages()) + ")",
            missing(record, "a barrier from the reading to the writing stages is missing or incomplete"));
    }
}

// Returns true if any live pass writes a part of `range` in the resource `ring`. `range` must have age 0,
// because passes write only the copy of the current frame.
bool Replay::anybody_writes(ResourceId ring, const SubresourceRange& range) const {
    return std::ranges::any_of(written_[ring], [&](const SubresourceRange& r) { return overlaps(r, range); });
}

// A group is a set of passes that runs in rounds. Returns true if the use accepts the result of the round
// that ran last, whichever round this is (UseDecl::latest), and if the cell has such content: the initial
// value, the content of an earlier frame, or the content that a round of the group wrote in this frame.
bool Replay::is_latest_content(PassId reader, const UseDecl& use, const Cell& cell) const {
    const Content& found = cell.content;
    if (!use.latest) return false;
    if (found.kind == Content::Kind::initial || found.kind == Content::Kind::carried) return true;
    if (found.kind != Content::Kind::written || found.frame != frame_) return false;
    const GroupDecl* group = find_group(plan_.graph, plan_.graph.passes[reader].rest_unit);
    return group != nullptr && group->has_unit(plan_.graph.passes[found.pass].rest_unit);
}

// Returns true if the cell has the content that the use wants:
// - If `wanted` is a pass: the content that this pass wrote in this frame.
// - If `wanted` is kNoId, for an import: the content that the program wrote before the frame.
// - If `wanted` is kNoId, for a persistent resource: its content of `age` frames ago. If fewer than `age`
//   frames have run, or if no live pass writes the history: its initial value (ResourceDecl::first_frame).
bool Replay::is_wanted_content(const UseDecl& use, const Cell& cell, PassId wanted) const {
    const Content& found = cell.content;
    if (wanted != kNoId)
        return found.kind == Content::Kind::written && found.pass == wanted && found.frame == frame_;
    const ResourceDecl& resource = plan_.graph.resources[use.resource];
    if (resource.ring == kNoId) return found.kind == Content::Kind::outside;
    // A persistent resource with a single copy has age 0, but a read of it sees the content of the previous
    // frame. So its age counts as 1.
    const uint32_t age = std::max(resource.age, 1u);
    const bool never_written = resource.history > 0 && !anybody_writes(resource.ring, cell.range);
    if (frame_ < age || never_written) return found.kind == Content::Kind::initial;
    return found.kind == Content::Kind::carried && found.frame == frame_ - age;
}

void Replay::expect_owner(const Actor& by, const UseDecl& use, Cell& cell) {
    const ResourceDecl& resource = plan_.graph.resources[use.resource];
    const std::vector<uint8_t>& concurrent = plan_.barriers.concurrent;
    const bool shared = use.resource < concurrent.size() && concurrent[use.resource] != 0;
    if (shared && (!resource.import || resource.import->concurrent)) return;
    if (cell.owner == kNoFamily) cell.owner = family();
    if (cell.owner == family() && cell.released_to == kNoFamily) return;
    faults_.add("C361", use.loc,
                faults_.actor_text(by, frame_) + " uses " + faults_.part_name(use.resource, cell.range) +
                    " on a queue of family " + std::to_string(family()) + ", but after " +
                    faults_.actor_text(cell.has_write ? cell.write.actor() : Actor{}, frame_) +
                    " this part belongs to family " +
                    std::to_string(cell.released_to == kNoFamily ? cell.owner : cell.released_to),
                "release and acquire the resource in between, or make it concurrent");
}

void Replay::expect_content(PassId id, const UseDecl& use, const Cell& cell, size_t& hint) {
    // A use may have thousands of sources, one per layer. So the search starts at the source that matched the
    // previous cell.
    const auto holds_cell = [&](const VersionSource& s) { return contains(s.range, cell.range); };
    const auto begin = use.sources.begin() + static_cast<std::ptrdiff_t>(std::min(hint, use.sources.size()));
    auto source = std::find_if(begin, use.sources.end(), holds_cell);
    if (source == use.sources.end()) {
        source = std::find_if(use.sources.begin(), begin, holds_cell);
        if (source == begin) source = use.sources.end();
    }
    if (source != use.sources.end()) hint = static_cast<size_t>(source - use.sources.begin());
    const PassId wanted = source == use.sources.end() ? kNoId : source->producer;
    const Content& found = cell.content;
    const std::optional<PassId> left = version_left(wanted, use.resource, cell.range);
    if (left && is_wanted_content(use, cell, *left)) return;
    if (wanted == kNoId && is_latest_content(id, use, cell)) return;
    std::string holds = "has no content";
    if (found.kind == Content::Kind::written)
        holds = "has the content that " + faults_.actor_text({found.pass, found.frame}, frame_) + " wrote";
    if (found.kind == Content::Kind::outside) holds = "still has the content from before the frame";
    if (found.kind == Content::Kind::initial) holds = "has its first-frame value";
    if (found.kind == Content::Kind::carried)
        holds = "has its content from " + std::to_string(frame_ - found.frame) + " frames ago";
    if (found.kind == Content::Kind::overwritten)
        holds = "was overwritten by " + faults_.actor_text({found.pass, found.frame}, frame_) + " through " +
                faults_.resource_name(found.through) + ", which shares the same memory";
    const std::string when = switches_text();
    faults_.add(
        when.empty() ? "C330" : "C349", use.loc,
        "pass " + faults_.pass_name(id) + " reads " + faults_.part_name(use.resource, cell.range) + " as " +
            (wanted == kNoId ? std::string("it was before the frame")
                             : "pass " + faults_.pass_name(wanted) + " leaves it") +
            ", but" + (when.empty() ? "" : when) + " the resource " + holds,
        when.empty()
            ? "the order of passes, the store operation of an attachment, or the sharing of memory is wrong"
            : "while a pass is switched off, its readers need the version before or another resource");
}

// Checks that no other resource in the same memory is still in use before `resource` is written. The first
// write is the layout transition of the barrier `transition`. If `transition` is null, the pass itself makes
// the first write, in `stages`.
void Replay::expect_free_memory(const Actor& by, ResourceId resource, SourceLoc loc, StageMask stages,
                                const BarrierDecl* transition) {
    const Scopes scopes = transition ? scopes_of(*transition) : Scopes{};
    // A barrier makes only those writes available that were made through the resources that it names.
    const auto is_flushed = [&](ResourceId owner, const AccessRecord& record) {
        const std::vector<ResourceId>& from = transition->aliased_from;
        if (std::find(from.begin(), from.end(), owner) != from.end()) return flushed(record, scopes);
        return !record.is_write() || covered(record) || record.available_before(scopes);
    };
    const auto expect_over = [&](ResourceId owner, AccessRecord& record) {
        follow(record);
        const bool over = transition ? ordered(record, scopes) && is_flushed(owner, record)
                                     : ordered(record, stages) && flushed(record, stages);
        if (over) return;
        faults_.add("C341", loc,
                    faults_.actor_text(by, frame_) + " begins to use memory for " +
                        faults_.resource_name(resource) + " that " +
                        faults_.actor_text(record.actor(), frame_) + " may still use through " +
                        faults_.resource_name(owner),
                    missing(record, "the alias transition from " + faults_.resource_name(owner) + " to " +
                                        faults_.resource_name(resource) +
                                        " needs a barrier whose source is " + stages_text(record.stages()) +
                                        " and " + access_text(record.access() & access::kAllWrites)));
    };
    for (const ResourceId owner : holders_.to_wait_for(resource)) {
        for (Cell& cell : cells_[owner]) {
            if (cell.has_write) expect_over(owner, cell.write);
            for (AccessRecord& record : cell.reads) expect_over(owner, record);
        }
    }
}

void Replay::take_memory(PassId by, ResourceId resource) {
    for (const ResourceId other : holders_.take_over(resource)) {
        for (Cell& cell : cells_[other]) {
            if (cell.content.kind == Content::Kind::written)
                cell.content = {Content::Kind::overwritten, by, frame_, resource};
            cell.layout = Layout::undefined;
        }
    }
}

}  // namespace weft::check
