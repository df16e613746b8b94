#include "graph/sync/track_whole.h"

#include <algorithm>
#include <utility>

#include "graph/sync/multi_queue_tracker.h"

namespace weft {
namespace {

bool is_usual(const ResourceDecl& decl, std::span<const RangeAccess> events) {
    if (decl.lifetime == ResourceLifetime::persistent || decl.ring != kNoId) return false;
    const SubresourceRange whole = decl.whole();
    return std::ranges::all_of(events, [&](const RangeAccess& access) {
        const SubresourceRange& range = access.range;
        return range.mip == whole.mip && range.mips == whole.mips && range.layer == whole.layer &&
               range.layers == whole.layers;
    });
}

// Sorts the barriers as track_resource() does, and merges equal ones. If only one queue uses the resource,
// the barriers are sorted already, so this function is not called.
void sort_unique(std::vector<CellBarrier>& barriers) {
    const auto key = [](const CellBarrier& barrier) { return merge_key(barrier); };
    std::ranges::sort(barriers, {}, key);
    const auto same = std::ranges::unique(barriers, {}, key);
    barriers.erase(same.begin(), same.end());
}

}  // namespace

template <class Tracker>
void WholeTracker::run(Tracker tracker, const ResourceDecl& decl) {
    const std::span<const AccessEvent> all(merged_);
    for (size_t i = 0; i < all.size(); ++i) tracker.advance(all.subspan(i), sync_);
    if (decl.import) tracker.release(decl.import->exit, sync_);
    tracker.add_last_uses(last_uses_);
}

void WholeTracker::run_on_queues(ResourceId id, const ResourceDecl& decl, const QueueUsage& usage) {
    const QueueRules rules{order_.queues, id, decl.kind == ResourceKind::image, usage.exclusive,
                           Position(order_.order.size())};
    if (decl.import)
        run(MultiQueueTracker(rules, decl.import->entry, changes_import(*decl.import, merged_)), decl);
    else
        run(MultiQueueTracker(rules, SingleQueueTracker::Start::taken_over), decl);
    sort_unique(sync_.barriers);
}

const WholeHistory* WholeTracker::track(ResourceId id, const ResourceDecl& decl,
                                        std::span<const RangeAccess> events) {
    if (!is_usual(decl, events)) return nullptr;
    merged_.clear();
    sync_.barriers.clear();
    sync_.dependencies.clear();
    last_uses_.clear();
    for (const RangeAccess& access : events) append_access(access.event, merged_);
    const std::span<const AccessEvent> all(merged_);
    const bool alone = order_.queues.size() == 1 && !decl.import;
    const QueueUsage usage = alone ? QueueUsage{} : queue_usage(decl, order_, {&all, 1});
    result_.concurrent = usage.concurrent();
    if (usage.several_queues)
        run_on_queues(id, decl, usage);
    else if (decl.import)
        run(SingleQueueTracker(decl.import->entry), decl);
    else
        run(SingleQueueTracker(SingleQueueTracker::Start::taken_over), decl);
    store(decl);
    return &result_;
}

// Stores the result of a tracker in result_.
void WholeTracker::store(const ResourceDecl& decl) {
    ResourceHistory& history = result_.history;
    history.barriers.clear();
    history.last_uses.clear();
    const SubresourceRange whole = decl.whole();
    for (const CellBarrier& barrier : sync_.barriers)
        history.barriers.push_back(placed_barrier(barrier, whole));
    if (last_uses_.size() == 1)
        history.last_uses.push_back(last_uses_.front());
    else
        add_last_uses(last_uses_, history.last_uses);
    std::swap(result_.dependencies, sync_.dependencies);
}

}  // namespace weft
