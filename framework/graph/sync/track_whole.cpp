#include "graph/sync/track_whole.h"

#include <algorithm>

namespace weft {
namespace {

bool is_usual(const ResourceDecl& decl, const std::vector<RangeAccess>& events, const Schedule& order) {
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

std::optional<ResourceHistory> track_whole(const ResourceDecl& decl, const std::vector<RangeAccess>& events,
                                           const Schedule& order) {
    if (!is_usual(decl, events, order)) return std::nullopt;
    std::vector<AccessEvent> merged;
    merged.reserve(events.size());
    for (const RangeAccess& access : events) append_access(access.event, merged);
    SingleQueueTracker tracker = decl.import ? SingleQueueTracker(decl.import->entry)
                                             : SingleQueueTracker(SingleQueueTracker::Start::taken_over);
    CellSync sync;
    const std::span<const AccessEvent> all(merged);
    for (size_t i = 0; i < all.size(); ++i) tracker.advance(all.subspan(i), sync);
    if (decl.import) tracker.release(decl.import->exit, sync);
    ResourceHistory history;
    history.barriers.reserve(sync.barriers.size());
    for (const CellBarrier& barrier : sync.barriers)
        history.barriers.push_back(placed_barrier(barrier, decl.whole()));
    tracker.add_last_uses(history.last_uses);
    return history;
}

}  // namespace weft
