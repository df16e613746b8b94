// Synchronisation, resource by resource. The frame repeats, so the memory that a transient takes over may
// have been left by the frame before; what a resource leaves behind does not depend on what it found, so that
// one walk over the frame serves both frames of the unroll: first every history, then the hand-overs between
// them.
#include <algorithm>
#include <tuple>
#include <utility>

#include "graph/stages.h"

namespace weft {
namespace {

struct HandOverRows {
    const std::vector<HandOver>& all;

    // Those into `to`. Every transient in use has at least one, from itself if from nobody else.
    [[nodiscard]] std::vector<HandOver> into(ResourceId to) const {
        const auto first = std::lower_bound(all.begin(), all.end(), to,
                                            [](const HandOver& h, ResourceId id) { return h.to < id; });
        const auto last = std::find_if(first, all.end(), [to](const HandOver& h) { return h.to != to; });
        if (first == last) return {{to, to, true}};
        return {first, last};
    }
};

// Waits for whoever used the memory last: by a barrier on the same queue, by a semaphore on another. Within a
// frame memory is shared only where the order of the queues is known already.
void take_over(const SyncTable& sync, const std::vector<HandOver>& owners, QueueIndex queue,
               PlacedBarrier& placed, std::vector<QueueDependency>& dependencies) {
    BarrierDecl& barrier = placed.barrier;
    barrier.from_previous_frame = true;
    bool first = true, elsewhere = false;
    for (const HandOver& owner : owners) {
        for (const LastUse& last : sync.histories[owner.from].last_uses) {
            barrier.from = first || barrier.from == last.pass ? last.pass : kNoId;
            first = false;
            if (last.queue != queue) {
                elsewhere = true;
                if (owner.wrap)
                    dependencies.push_back({last.position, placed.position, true, barrier.resource});
                continue;
            }
            barrier.src.stages |= last.stages;
            barrier.src.access |= last.writes;
        }
        barrier.from_previous_frame = barrier.from_previous_frame && owner.wrap;
        if (barrier.hand_over_from.empty() || barrier.hand_over_from.back() != owner.from)
            barrier.hand_over_from.push_back(owner.from);
    }
    if (elsewhere) barrier.src.stages |= barrier.dst.stages;
}

void put(PlacedBarrier placed, const Schedule& order, BarrierPlan& plan) {
    if (placed.position == kEpiloguePosition) {
        plan.epilogue.push_back(std::move(placed.barrier));
        return;
    }
    PassStep& step = plan.steps[placed.position];
    if (!placed.after) placed.barrier.to = order.order[placed.position];
    (placed.after ? step.after : step.barriers).push_back(std::move(placed.barrier));
}

// Every copy of a persistent resource: out of undefined, cleared, into the state that the first frame
// expects.
void add_to_prologue(const ResolvedGraph& graph, ResourceId id, const ResourceHistory& history,
                     ProloguePlan& prologue) {
    constexpr AccessMask kHostAccess = access::kHostRead | access::kHostWrite;
    const ResourceDecl& resource = graph.resources[id];
    const bool image = resource.kind == ResourceKind::image;
    const AccessState cleared =
        access_state(Access::clear_write, 0, image ? resource.aspects : aspect::kNone);
    BarrierDecl barrier;
    barrier.resource = id;
    barrier.reason = BarrierReason::prologue;
    barrier.range = resource.whole();
    barrier.dst = cleared;
    if (image) prologue.before.push_back(barrier);
    prologue.cleared.push_back(id);
    barrier.src = cleared;
    for (const BoundaryState& entry : history.entry) {
        barrier.range = entry.range;
        barrier.dst = {stage::kAll & ~stage::kHost, access::kAll & ~kHostAccess, entry.state.layout};
        prologue.after.push_back(barrier);
    }
}

uint32_t count_emitted(const BarrierPlan& plan) {
    size_t count = plan.epilogue.size();
    for (const PassStep& step : plan.steps) count += step.barriers.size() + step.after.size();
    return static_cast<uint32_t>(count);
}

}  // namespace

BarrierPlan barriers(const ResolvedGraph& graph, const Schedule& order, const SyncTable& sync,
                     const MemoryPlan& memory, std::vector<std::vector<AttachmentOps>> attachments,
                     std::vector<QueueDependency>& dependencies) {
    BarrierPlan plan;
    plan.concurrent = sync.concurrent;
    plan.steps.resize(order.order.size());
    for (uint32_t position = 0; position < order.order.size(); ++position) {
        plan.steps[position].pass = order.order[position];
        plan.steps[position].attachments = std::move(attachments[position]);
        plan.steps[position].continues_scope = sync.scopes[position] != kNoId;
    }
    const HandOverRows rows{memory.hand_overs};
    for (ResourceId id = 0; id < graph.resources.size(); ++id) {
        const std::vector<HandOver> owners = rows.into(id);
        for (PlacedBarrier placed : sync.histories[id].barriers) {
            placed.barrier.resource = id;
            if (placed.barrier.reason == BarrierReason::hand_over)
                take_over(sync, owners, order.queue[placed.position], placed, dependencies);
            put(std::move(placed), order, plan);
        }
        if (!sync.histories[id].entry.empty()) add_to_prologue(graph, id, sync.histories[id], plan.prologue);
    }
    plan.emitted = count_emitted(plan);
    return plan;
}

}  // namespace weft
