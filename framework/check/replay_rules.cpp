// What the replay expects of each access: order, visibility, layout, content, memory that nobody else still
// uses.
#include <algorithm>

#include "check/replay.h"

namespace weft::check {

void Replay::expect_order(const Actor& actor, const UseDecl& use, const Cell& cell, const AccessState& state,
                          bool is_write) {
    const bool judged_as_read = is_write && reads(use.access);
    const std::string who = faults_.actor_text(actor, frame_);
    const std::string what = faults_.resource_name(use.resource) + range_text(cell.range);
    const bool image = plan_.graph.resources[use.resource].kind == ResourceKind::image;
    if (image && !judged_as_read && cell.layout != state.layout)
        faults_.add("C320", use.loc,
                    who + " needs " + what + " in " + layout_text(state.layout) + ", but " +
                        faults_.actor_text(cell.has_write ? cell.write.actor() : Actor{}, frame_) +
                        " left it in " + layout_text(cell.layout),
                    "a barrier before " + who + " must change the layout");
    if (cell.has_write && !judged_as_read &&
        (!cell.write.ordered_before(state.stages) || !cell.write.available() ||
         !cell.write.visible_to(state.stages, state.access))) {
        faults_.add(is_write ? "C312" : "C310", use.loc,
                    who + (is_write ? " writes " : " reads ") + what + " (" + access_text(state.access) +
                        " in " + stages_text(state.stages) + "), but what " +
                        faults_.actor_text(cell.write.actor(), frame_) + " wrote (" +
                        access_text(cell.write.access()) + " in " + stages_text(cell.write.stages()) +
                        ") is not made visible to it",
                    "a barrier between them is missing, or its stages or accesses are too weak");
    }
    if (!is_write) return;
    for (const AccessRecord& record : cell.reads) {
        if (record.ordered_before(state.stages)) continue;
        faults_.add("C311", use.loc,
                    who + " writes " + what + " while " + faults_.actor_text(record.actor(), frame_) +
                        " may still read it (" + stages_text(record.stages()) + ")",
                    "a barrier from the reading to the writing stages is missing or too weak");
    }
}

void Replay::expect_content(PassId id, const UseDecl& use, const Cell& cell) {
    const auto source = std::find_if(use.sources.begin(), use.sources.end(),
                                     [&](const VersionSource& s) { return contains(s.range, cell.range); });
    const PassId wanted = source == use.sources.end() ? kNoId : source->producer;
    const Content& found = cell.content;
    const bool right = wanted == kNoId ? found.kind == Content::Kind::outside
                                       : found.kind == Content::Kind::written && found.pass == wanted &&
                                             found.frame == frame_;
    if (right) return;
    std::string holds = "holds nothing";
    if (found.kind == Content::Kind::written)
        holds = "holds what " + faults_.actor_text({found.pass, found.frame}, frame_) + " wrote";
    if (found.kind == Content::Kind::outside) holds = "still holds what was there before the frame";
    if (found.kind == Content::Kind::overwritten)
        holds = "was overwritten by " + faults_.actor_text({found.pass, found.frame}, frame_) + " through " +
                faults_.resource_name(found.through) + ", which shares its memory";
    faults_.add("C330", use.loc,
                "pass " + faults_.pass_name(id) + " reads " + faults_.resource_name(use.resource) +
                    range_text(cell.range) + " as " +
                    (wanted == kNoId ? std::string("it was before the frame")
                                     : "pass " + faults_.pass_name(wanted) + " leaves it") +
                    ", but it " + holds,
                "the order of passes, an attachment's store operation, or a shared placement is wrong");
}

// `resource` is about to be written: whoever else uses its memory must be done. `transition` is the barrier
// that writes first, or null when the pass itself does, in `stages`.
void Replay::expect_free_memory(const Actor& actor, ResourceId resource, SourceLoc loc, StageMask stages,
                                const Scopes* transition) {
    const auto expect_over = [&](ResourceId owner, const AccessRecord& record) {
        const bool ordered = transition ? record.ordered_before(*transition) : record.ordered_before(stages);
        const bool flushed = !record.is_write() || record.available() ||
                             (transition && (record.stages() & ~transition->src_memory) == 0 &&
                              (record.access() & access::kAllWrites & ~transition->src_access) == 0);
        if (ordered && flushed) return;
        faults_.add(
            "C341", loc,
            faults_.actor_text(actor, frame_) + " takes over memory for " + faults_.resource_name(resource) +
                " that " + faults_.actor_text(record.actor(), frame_) + " may still use through " +
                faults_.resource_name(owner),
            "the hand-over from " + faults_.resource_name(owner) + " to " + faults_.resource_name(resource) +
                " needs a barrier whose source is " + stages_text(record.stages()) + " and " +
                access_text(record.access() & access::kAllWrites));
    };
    for (const ResourceId owner : neighbours_[resource]) {
        for (const Cell& cell : cells_[owner]) {
            if (cell.has_write) expect_over(owner, cell.write);
            for (const AccessRecord& record : cell.reads) expect_over(owner, record);
        }
    }
}

void Replay::overwrite_neighbours(PassId by, ResourceId resource) {
    for (const ResourceId other : neighbours_[resource]) {
        for (Cell& cell : cells_[other]) {
            if (cell.content.kind == Content::Kind::written)
                cell.content = {Content::Kind::overwritten, by, frame_, resource};
            cell.layout = Layout::undefined;
        }
    }
}

void Replay::leave_frame() {
    for (ResourceId id = 0; id < cells_.size(); ++id) {
        const ResourceDecl& resource = plan_.graph.resources[id];
        if (!resource.import) continue;
        UseDecl outside;
        outside.resource = id;
        outside.loc = resource.loc;
        const AccessState& exit = resource.import->exit;
        for (const Cell& cell : cells_[id]) {
            const bool touched =
                cell.content.kind == Content::Kind::written || cell.layout != Layout::undefined;
            if (touched) expect_order({kNoId, frame_}, outside, cell, exit, false);
        }
    }
}

}  // namespace weft::check
