// Collects all barriers of a frame. The history of each resource (its barriers and last uses in one frame) is
// already known. A frame always leaves a resource in the same state, so the history is also valid for the
// previous frame. This file then extends the barriers between resources that share memory.
#include <algorithm>
#include <tuple>
#include <utility>

#include "graph/schedule/fully_written.h"
#include "graph/sync/barriers.h"

namespace weft {
namespace {

// Returns all kinds of write access that commands can make in these pipeline stages.
AccessMask writes_of(StageMask stages) {
    constexpr StageMask kShaders = stage::kComputeShader | stage::kVertexShader | stage::kFragmentShader;
    constexpr StageMask kTransfers = stage::kCopy | stage::kBlit | stage::kResolve | stage::kClear;
    constexpr StageMask kTests = stage::kEarlyFragmentTests | stage::kLateFragmentTests;
    AccessMask mask = access::kNone;
    if (stages & kShaders) mask |= access::kStorageWrite;
    if (stages & kTransfers) mask |= access::kTransferWrite;
    if (stages & kTests) mask |= access::kDepthStencilWrite;
    if (stages & stage::kColorOutput) mask |= access::kColorWrite;
    return mask;
}

struct AliasTransitionRows {
    const std::vector<AliasTransition>& all;

    // Returns the alias transitions whose new owner is `to`. Every transient in use has at least one: if no
    // other resource uses its memory, it takes the memory over from its own use in the previous frame.
    [[nodiscard]] std::vector<AliasTransition> into(ResourceId to) const {
        const auto first = std::lower_bound(
            all.begin(), all.end(), to, [](const AliasTransition& h, ResourceId id) { return h.to < id; });
        const auto last =
            std::find_if(first, all.end(), [to](const AliasTransition& h) { return h.to != to; });
        if (first == last) return {{to, to, true}};
        return {first, last};
    }
};

// Resources A, B and C use the same memory, one after the other. The alias barrier before C waits for B, the
// direct previous owner. This class finds the earlier owners, such as A, for which this barrier must wait
// too:
// - B wrote only a part of the memory. Only the barrier before B waited for the accesses to the rest of A. So
//   the order of A and C depends on a barrier of another resource, and the validation layer of
//   Vulkan 1.3.239 does not follow such a chain.
// - B is a buffer and C is an image, or the reverse. The layer does not see that they overwrite each other.
class EarlierOwners {
 public:
    EarlierOwners(const ResolvedGraph& graph, const Schedule& order, const AliasTransitionRows& rows)
        : graph_(graph), rows_(rows), whole_(fully_written(graph, order)) {}

    [[nodiscard]] std::vector<ResourceId> of(ResourceId to,
                                             const std::vector<AliasTransition>& owners) const {
        std::vector<ResourceId> found, left;
        const auto look_behind = [&](ResourceId owner) {
            const bool hides = whole_[owner] && graph_.resources[owner].kind == graph_.resources[to].kind;
            if (!hides) left.push_back(owner);
        };
        for (const AliasTransition& owner : owners) look_behind(owner.from);
        while (!left.empty()) {
            const ResourceId owner = left.back();
            left.pop_back();
            for (const AliasTransition& before : rows_.into(owner)) {
                if (std::find(found.begin(), found.end(), before.from) != found.end()) continue;
                found.push_back(before.from);
                look_behind(before.from);
            }
        }
        return found;
    }

 private:
    const ResolvedGraph& graph_;
    const AliasTransitionRows& rows_;
    std::vector<uint8_t> whole_;
};

// Adds the last uses of `owner` on this queue to the source scope of a barrier: their stages, and all writes
// that are possible in these stages.
void wait_for(const ResourceHistory& owner, QueueIndex queue, AccessState& src) {
    for (const LastUse& last : owner.last_uses) {
        if (last.queue != queue) continue;
        src.stages |= last.stages;
        src.access |= writes_of(last.stages);
    }
}

// Makes the alias barrier wait for the last users of the memory. For users on the same queue, their stages go
// into the barrier's source. Users on another queue need a semaphore; within a frame, resources share memory
// only if semaphores already order them.
void take_over(const SyncTable& sync, const std::vector<AliasTransition>& owners, QueueIndex queue,
               PlacedBarrier& placed, std::vector<QueueDependency>& dependencies) {
    BarrierDecl& barrier = placed.barrier;
    barrier.from_previous_frame = true;
    bool first = true, elsewhere = false;
    for (const AliasTransition& owner : owners) {
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
        if (barrier.aliased_from.empty() || barrier.aliased_from.back() != owner.from)
            barrier.aliased_from.push_back(owner.from);
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

// Adds the commands that initialise one copy of a persistent resource to the prologue: for an image a
// transition from UNDEFINED, then a clear, then a barrier to the state that the first frame expects.
void add_to_prologue(const ResolvedGraph& graph, ResourceId id, const ResourceHistory& history,
                     ProloguePlan& prologue) {
    constexpr AccessMask kHostAccess = access::kHostRead | access::kHostWrite;
    const ResourceDecl& resource = graph.resources[id];
    const bool image = resource.kind == ResourceKind::image;
    const AccessState cleared = clear_state(resource);
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

BarrierResult barriers(const ResolvedGraph& graph, const Schedule& order, const SyncTable& sync,
                       const MemoryPlan& memory, const AttachmentTable& attachments) {
    BarrierResult result;
    BarrierPlan& plan = result.plan;
    plan.concurrent = sync.concurrent;
    plan.steps.resize(order.order.size());
    for (Position position(0); position < order.order.size(); ++position) {
        plan.steps[position].pass = order.order[position];
        plan.steps[position].attachments = attachments[position];
        plan.steps[position].merges_render_pass = sync.scopes[position] != kNoId;
    }
    const AliasTransitionRows rows{memory.alias_transitions};
    const EarlierOwners earlier(graph, order, rows);
    for (ResourceId id(0); id < graph.resources.size(); ++id) {
        const std::vector<AliasTransition> owners = rows.into(id);
        for (PlacedBarrier placed : sync.histories[id].barriers) {
            placed.barrier.resource = id;
            if (placed.barrier.reason == BarrierReason::alias) {
                const QueueIndex queue = order.queue[placed.position];
                take_over(sync, owners, queue, placed, result.memory_dependencies);
                for (const ResourceId before : earlier.of(id, owners))
                    wait_for(sync.histories[before], queue, placed.barrier.src);
            }
            put(std::move(placed), order, plan);
        }
        if (!sync.histories[id].entry.empty()) add_to_prologue(graph, id, sync.histories[id], plan.prologue);
    }
    plan.emitted = count_emitted(plan);
    return result;
}

}  // namespace weft
