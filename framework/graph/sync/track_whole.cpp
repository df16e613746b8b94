#include "graph/sync/track_whole.h"

#include <algorithm>

namespace weft {
namespace {

bool is_usual(const ResourceDecl& decl, std::span<const RangeAccess> events, const Schedule& order) {
    if (decl.lifetime == ResourceLifetime::persistent || decl.ring != kNoId) return false;
    const QueueIndex queue = events.front().event.queue;
    // An import enters and leaves the frame on queue 0.
    if (decl.import && (queue != kGraphicsQueue || decl.import->family != order.queues[queue].family))
        return false;
    const SubresourceRange whole = decl.whole();
    return std::ranges::all_of(events, [&](const RangeAccess& access) {
        const SubresourceRange& range = access.range;
        return access.event.queue == queue && range.mip == whole.mip && range.mips == whole.mips &&
               range.layer == whole.layer && range.layers == whole.layers;
    });
}

}  // namespace

const ResourceHistory* WholeTracker::track(const ResourceDecl& decl, std::span<const RangeAccess> events) {
    if (!is_usual(decl, events, order_)) return nullptr;
    merged_.clear();
    sync_.barriers.clear();
    history_.barriers.clear();
    history_.last_uses.clear();
    for (const RangeAccess& access : events) append_access(access.event, merged_);
    SingleQueueTracker tracker = decl.import ? SingleQueueTracker(decl.import->entry)
                                             : SingleQueueTracker(SingleQueueTracker::Start::taken_over);
    const std::span<const AccessEvent> all(merged_);
    for (size_t i = 0; i < all.size(); ++i) tracker.advance(all.subspan(i), sync_);
    if (decl.import) tracker.release(decl.import->exit, sync_);
    const SubresourceRange whole = decl.whole();
    for (const CellBarrier& barrier : sync_.barriers)
        history_.barriers.push_back(placed_barrier(barrier, whole));
    tracker.add_last_uses(history_.last_uses);
    return &history_;
}

}  // namespace weft
