// Simulates how the program outside the graph hands imports to the frame and gets them back.
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
        // An access that only writes. If the access could also read, expect_order() would leave out the
        // checks that belong to read().
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

}  // namespace weft::check
