// Simulates how the program outside the graph hands imports to the frame and gets them back, and how it reads
// persistent resources between two frames.
#include <vector>

#include "check/replay.h"

namespace weft::check {
namespace {

bool is_outside(const Actor& actor) {
    return actor.pass == kNoId && !actor.transition;
}

}  // namespace

void Replay::enter_imports() {
    for (ResourceId id(0); id < cells_.size(); ++id) {
        const ResourceDecl& resource = plan_.graph.resources[id];
        if (!resource.import) continue;
        const AccessState& entry = resource.import->entry;
        const bool pending = (entry.access & access::kAllWrites) != 0;
        // The accesses of the program happen after all work of queue 0 in the previous frame.
        const Actor outside{
            kNoId, frame_, false, kGraphicsQueue, clock_.batches_begun(kGraphicsQueue), 0, logs_[0].count()};
        for (Cell& cell : cells_[id]) {
            const AccessRecord record(outside, entry.stages, entry.access, pending);
            cell.reads.clear();
            cell.has_write = pending;
            if (pending) cell.write = record;
            if (!pending && entry.stages != 0) cell.reads.push_back(record);
            const bool dropped = resource.kind == ResourceKind::image && entry.layout == Layout::undefined;
            cell.content = dropped ? Content{} : Content{Content::Kind::outside, kNoId, frame_, kNoId};
            if (!dropped) cell.layout = entry.layout;
            cell.owner = resource.import->family;
        }
    }
}

void Replay::leave_imports() {
    for (ResourceId id(0); id < cells_.size(); ++id) {
        const ResourceDecl& resource = plan_.graph.resources[id];
        if (!resource.import) continue;
        UseDecl outside;
        outside.resource = id;
        // The program's access counts as an access that only writes. If the access could also read,
        // expect_order() would leave out the checks that read() makes.
        outside.access = Access::storage_write;
        outside.loc = resource.loc;
        const AccessState& exit = resource.import->exit;
        const bool writes_next = (exit.access & access::kAllWrites) != 0;
        for (Cell cell : cells_[id]) {
            std::erase_if(cell.reads, [](const AccessRecord& r) { return is_outside(r.actor()); });
            const bool touched = cell.content.kind == Content::Kind::written ||
                                 cell.layout != Layout::undefined || !cell.reads.empty();
            expect_written_output(id, cell);
            if (touched) expect_order(actor(kNoId), outside, cell, exit, writes_next);
        }
    }
}

// Simulates the program's reads of persistent resources. They happen after all work of queue 0 in this frame,
// and before the work of queue 0 in the next frame.
void Replay::read_kept() {
    for (ResourceId id(0); id < cells_.size(); ++id) {
        const ResourceDecl& resource = plan_.graph.resources[id];
        if (!resource.between || !plan_.live.live_resources[id]) continue;
        const Actor outside{
            kNoId, frame_, false, kGraphicsQueue, clock_.batches_begun(kGraphicsQueue), 0, logs_[0].count()};
        UseDecl use;
        use.resource = id;
        use.access = Access::copy_read;
        use.loc = resource.loc;
        for (Cell& cell : cells_[id]) {
            expect_owner(actor(kNoId), use, cell);
            expect_order(actor(kNoId), use, cell, *resource.between, false);
            expect_kept(id, cell);
            note_read(cell, AccessRecord(outside, resource.between->stages, resource.between->access, false));
        }
    }
}

// Checks that a resource with a single copy has content when the program reads it. Resources with history are
// not checked: if no pass writes a part in this frame, this part has no content in the copy of this frame.
void Replay::expect_kept(ResourceId id, const Cell& cell) {
    const ResourceDecl& resource = plan_.graph.resources[id];
    const bool lost =
        cell.content.kind == Content::Kind::undefined || cell.content.kind == Content::Kind::overwritten;
    if (resource.history > 0 || !lost) return;
    faults_.add("C330", resource.loc,
                "the program reads " + faults_.part_name(id, cell.range) +
                    " after the frame, but the resource has lost its content",
                "the store operation of an attachment, or the sharing of memory is wrong");
}

}  // namespace weft::check
