// Synchronisation, resource by resource. The frame repeats, so the memory that a transient takes over may
// have been left by the frame before; what a resource leaves behind does not depend on what it found, so that
// one walk over the frame serves both frames of the unroll: first every history, then the hand-overs between
// them.
#include <algorithm>
#include <tuple>
#include <utility>

#include "graph/barrier_history.h"
#include "graph/stages.h"

namespace weft {
namespace {

// Load and store operations touch an attachment too; DONT_CARE counts as a write.
void add_attachment_access(const AttachmentOps& ops, const UseDecl& use, Touch& touch) {
    const bool depth = (use.range.aspects & (aspect::kDepth | aspect::kStencil)) != 0;
    const AccessMask read = depth ? access::kDepthStencilRead : access::kColorRead;
    const AccessMask write = depth ? access::kDepthStencilWrite : access::kColorWrite;
    if (ops.load == LoadOp::load) touch.state.access |= read;
    const bool discards = ops.load == LoadOp::dont_care || ops.store == StoreOp::dont_care;
    const bool stores = ops.load == LoadOp::clear || ops.store == StoreOp::store;
    if (!discards && !stores) return;
    touch.state.access |= write;
    touch.writes = true;
}

// By resource, in order of position.
std::vector<std::vector<RangeTouch>> collect_touches(
    const ResolvedGraph& graph, const Schedule& order,
    const std::vector<std::vector<AttachmentOps>>& attachments) {
    std::vector<std::vector<RangeTouch>> touches(graph.resources.size());
    for (uint32_t position = 0; position < order.order.size(); ++position) {
        const PassId id = order.order[position];
        const PassDecl& pass = graph.passes[id];
        for (uint32_t u = 0; u < pass.uses.size(); ++u) {
            const UseDecl& use = pass.uses[u];
            Touch touch{position, id, use.state, writes(use.access), reads(use.access)};
            for (const AttachmentOps& ops : attachments[position])
                if (ops.use == u) add_attachment_access(ops, use, touch);
            touches[use.resource].push_back({use.range, touch});
        }
    }
    return touches;
}

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

void take_over(const std::vector<ResourceHistory>& histories, const std::vector<HandOver>& owners,
               BarrierDecl& barrier) {
    barrier.from_previous_frame = true;
    bool first = true;
    for (const HandOver& owner : owners) {
        const Pending& last = histories[owner.from].last;
        barrier.from = first || barrier.from == last.pass ? last.pass : kNoId;
        first = false;
        barrier.src.stages |= last.stages;
        barrier.src.access |= last.writes;
        barrier.from_previous_frame = barrier.from_previous_frame && owner.wrap;
        if (barrier.hand_over_from.empty() || barrier.hand_over_from.back() != owner.from)
            barrier.hand_over_from.push_back(owner.from);
    }
}

void put(PlacedBarrier placed, const Schedule& order, BarrierPlan& plan) {
    if (placed.position == kEpiloguePosition) {
        plan.epilogue.push_back(std::move(placed.barrier));
        return;
    }
    placed.barrier.to = order.order[placed.position];
    plan.steps[placed.position].barriers.push_back(std::move(placed.barrier));
}

}  // namespace

BarrierPlan barriers(const ResolvedGraph& graph, const Schedule& order, const Lifetimes&,
                     const MemoryPlan& memory, std::vector<std::vector<AttachmentOps>> attachments) {
    const std::vector<std::vector<RangeTouch>> touches = collect_touches(graph, order, attachments);
    std::vector<ResourceHistory> histories(graph.resources.size());
    for (ResourceId id = 0; id < graph.resources.size(); ++id)
        if (!touches[id].empty()) histories[id] = resource_history(graph.resources[id], touches[id]);

    BarrierPlan plan;
    plan.steps.resize(order.order.size());
    for (uint32_t position = 0; position < order.order.size(); ++position) {
        plan.steps[position].pass = order.order[position];
        plan.steps[position].attachments = std::move(attachments[position]);
    }
    const HandOverRows rows{memory.hand_overs};
    for (ResourceId id = 0; id < graph.resources.size(); ++id) {
        const std::vector<HandOver> owners = rows.into(id);
        for (const PlacedBarrier& placed : histories[id].barriers) {
            PlacedBarrier own = placed;
            own.barrier.resource = id;
            if (own.barrier.reason == BarrierReason::hand_over) take_over(histories, owners, own.barrier);
            put(std::move(own), order, plan);
        }
    }
    plan.emitted = static_cast<uint32_t>(plan.epilogue.size());
    for (const PassStep& step : plan.steps) plan.emitted += static_cast<uint32_t>(step.barriers.size());
    return plan;
}

}  // namespace weft
