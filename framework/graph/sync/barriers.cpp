// Collects all barriers of a frame. The history of each resource (its barriers and last uses in one frame) is
// already known. A frame always leaves a resource in the same state, so the history is also valid for the
// previous frame. This file then extends the alias barriers, with which a resource takes over memory: they
// must wait for the resources that used the memory before.
#include <algorithm>
#include <numeric>
#include <span>

#include "graph/schedule/fully_written.h"
#include "graph/sync/barriers.h"
#include "graph/sync/group_blocks.h"
#include "graph/sync/skipped_reads.h"

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

// Finds the alias transitions by their new owner. An alias transition is a takeover of memory: from the
// resource that used the memory before, to the new owner.
class AliasTransitionRows {
 public:
    AliasTransitionRows(const std::vector<AliasTransition>& all, size_t resource_count)
        : all_(all), first_(resource_count + 1, 0) {
        for (const AliasTransition& transition : all) ++first_[transition.to + 1];
        std::partial_sum(first_.begin(), first_.end(), first_.begin());
        own_.reserve(resource_count);
        for (ResourceId id(0); id < resource_count; ++id) own_.push_back({id, id, true});
    }

    // Returns the alias transitions (takeovers of memory) whose new owner is `to`. Every transient in use has
    // at least one: if no other resource uses its memory, the transient takes the memory over from its own
    // use in the previous frame.
    [[nodiscard]] std::span<const AliasTransition> into(ResourceId to) const {
        if (first_[to] == first_[to + 1]) return {&own_[to], 1};
        return std::span(all_).subspan(first_[to], first_[to + 1] - first_[to]);
    }

 private:
    const std::vector<AliasTransition>& all_;  // All alias transitions, sorted by the new owner.
    // Index: ResourceId. The index in all_ of the first transition whose new owner is this resource.
    std::vector<uint32_t> first_;
    // Index: ResourceId. The alias transition with which the resource takes over its own memory from the
    // previous frame.
    std::vector<AliasTransition> own_;
};

// Resources A, B and C use the same memory, one after the other. The alias barrier before C waits for B, the
// direct previous owner. This class finds the earlier owners, such as A, for which this barrier must wait
// too:
// - B did not overwrite all of the memory of A. For the bytes that B did not write, only a chain of two
//   barriers orders A and C: the barrier before B waits for A, and the barrier before C waits for B. The
//   validation layer of Vulkan 1.3.239 does not follow such a chain.
// - B is a buffer and C is an image, or the reverse. The layer does not see that they overwrite each other.
class EarlierOwners {
 public:
    EarlierOwners(const ResolvedGraph& graph, const Schedule& order, const AliasTransitionRows& rows)
        : graph_(graph), rows_(rows), whole_(fully_written(graph, order)) {}

    [[nodiscard]] std::vector<ResourceId> of(ResourceId to, std::span<const AliasTransition> owners) const {
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

// Adds the last uses of an owner on this queue to the source scope of a barrier: their stages, and all writes
// that are possible in these stages.
void wait_for(std::span<const LastUse> last_uses, QueueIndex queue, AccessState& src) {
    for (const LastUse& last : last_uses) {
        if (last.queue != queue) continue;
        src.stages |= last.stages;
        src.access |= writes_of(last.stages);
    }
}

// Makes the alias barrier wait for the last users of the memory. For users on the same queue, their stages go
// into the barrier's source scope. A user on another queue needs a semaphore wait. Within one frame,
// resources share memory only if semaphores already order them. So a new semaphore wait is needed only for
// users in the previous frame.
void take_over(const SyncTable& sync, std::span<const AliasTransition> owners, QueueIndex queue,
               Position position, BarrierDecl& barrier, std::vector<QueueDependency>& dependencies) {
    barrier.from_previous_frame = true;
    barrier.aliased_from.reserve(owners.size());
    bool first = true, elsewhere = false;
    for (const AliasTransition& owner : owners) {
        for (const LastUse& last : sync.histories[owner.from].last_uses) {
            barrier.from = first || barrier.from == last.pass ? last.pass : kNoId;
            first = false;
            if (last.queue != queue) {
                elsewhere = true;
                if (owner.wrap) dependencies.push_back({last.position, position, true, barrier.resource});
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

BarrierDecl barrier_of(ResourceId resource, const TrackedBarrier& tracked) {
    return {.resource = resource,
            .range = tracked.range,
            .src = tracked.src,
            .dst = tracked.dst,
            .src_family = tracked.src_family,
            .dst_family = tracked.dst_family,
            .reason = tracked.reason,
            .from = tracked.from,
            .from_previous_frame = tracked.from_previous_frame,
            .aliased_from = {}};
}

// Returns a plan with one step for each pass. The lists of barriers in the steps are empty, but have enough
// memory for the barriers of `sync`.
BarrierPlan empty_plan(const Schedule& order, const SyncTable& sync, const AttachmentTable& attachments) {
    BarrierPlan plan;
    plan.concurrent = sync.concurrent;
    plan.steps.resize(order.order.size());
    std::vector<uint32_t> before(plan.steps.size(), 0);
    for (const PlacedBarrier& placed : sync.histories.barriers())
        if (placed.position != kEpiloguePosition && !placed.after) ++before[placed.position];
    for (Position position(0); position < order.order.size(); ++position) {
        PassStep& step = plan.steps[position];
        step.pass = order.order[position];
        step.attachments = attachments[position];
        step.merges_render_pass = sync.scopes[position] != kNoId;
        step.barriers.reserve(before[position]);
    }
    return plan;
}

// Adds a barrier to the plan, at its place, and returns it.
BarrierDecl& add_barrier(const PlacedBarrier& placed, ResourceId resource, const Schedule& order,
                         BarrierPlan& plan) {
    ++plan.emitted;
    if (placed.position == kEpiloguePosition)
        return plan.epilogue.emplace_back(barrier_of(resource, placed.barrier));
    PassStep& step = plan.steps[placed.position];
    if (placed.after) return step.after.emplace_back(barrier_of(resource, placed.barrier));
    BarrierDecl& barrier = step.barriers.emplace_back(barrier_of(resource, placed.barrier));
    barrier.to = order.order[placed.position];
    return barrier;
}

// Marks the barriers around the writes of rest units (sets of passes that run only in some frames). Marked
// barriers are recorded only in frames in which the pass runs.
void mark_rest_units(const ResolvedGraph& graph, BarrierPlan& plan) {
    for (PassStep& step : plan.steps) {
        const PassDecl& pass = graph.passes[step.pass];
        if (pass.rest_unit == kNoId) continue;
        for (std::vector<BarrierDecl>* list : {&step.barriers, &step.after})
            for (BarrierDecl& barrier : *list)
                barrier.if_pass_runs = std::ranges::any_of(pass.uses, [&](const UseDecl& use) {
                    return writes(use.access) && use.resource == barrier.resource &&
                           overlaps(use.range, barrier.range);
                });
    }
}

// Adds the commands that initialise one copy of a persistent resource to the prologue: for an image a
// transition from UNDEFINED, then a clear, then a barrier to the state that the first frame expects.
void add_to_prologue(const ResolvedGraph& graph, ResourceId id, std::span<const BoundaryState> entries,
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
    for (const BoundaryState& entry : entries) {
        barrier.range = entry.range;
        barrier.dst = {stage::kAll & ~stage::kHost, access::kAll & ~kHostAccess, entry.state.layout};
        prologue.after.push_back(barrier);
    }
}

}  // namespace

BarrierResult barriers(const ResolvedGraph& graph, const Schedule& order, const SyncTable& sync,
                       const MemoryPlan& memory, const AttachmentTable& attachments) {
    BarrierResult result;
    BarrierPlan& plan = result.plan;
    plan = empty_plan(order, sync, attachments);
    const AliasTransitionRows rows(memory.alias_transitions, graph.resources.size());
    const EarlierOwners earlier(graph, order, rows);
    for (ResourceId id(0); id < graph.resources.size(); ++id) {
        const HistoryTable::Row history = sync.histories[id];
        for (const PlacedBarrier& placed : history.barriers) {
            BarrierDecl& barrier = add_barrier(placed, id, order, plan);
            if (barrier.reason != BarrierReason::alias) continue;
            const QueueIndex queue = order.queue[placed.position];
            const std::span<const AliasTransition> owners = rows.into(id);
            take_over(sync, owners, queue, placed.position, barrier, result.memory_dependencies);
            for (const ResourceId before : earlier.of(id, owners))
                wait_for(sync.histories[before].last_uses, queue, barrier.src);
        }
        if (!history.entry.empty()) add_to_prologue(graph, id, history.entry, plan.prologue);
    }
    if (graph.rest_unit_count > 0) mark_rest_units(graph, plan);
    name_skipped_reads(graph, plan);
    if (!graph.groups.empty()) move_shared_barriers(group_blocks(graph, order), plan);
    return result;
}

}  // namespace weft
