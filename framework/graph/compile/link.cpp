#include <utility>

#include "graph/compile/link.h"
#include "weft/compile.h"

namespace weft {
namespace {

// An import's entry and exit describe the same point between two frames, so that the exit state is what is
// left there.
std::vector<BoundaryState> boundary_states(const ResolvedGraph& graph, const LiveGraph& live,
                                           const SyncTable& sync) {
    std::vector<BoundaryState> states;
    for (ResourceId id = 0; id < graph.resources.size(); ++id) {
        const ResourceDecl& resource = graph.resources[id];
        if (live.live_resources[id] && resource.import)
            states.push_back({id, resource.whole(), resource.import->exit, resource.import->family});
        for (BoundaryState state : sync.histories[id].entry) {
            state.resource = id;
            states.push_back(state);
        }
    }
    return states;
}

}  // namespace

FramePlan link(ResolvedGraph graph, LiveGraph live, Schedule order, const SyncTable& sync, Lifetimes spans,
               MemoryPlan memory, BarrierPlan barrier_plan, SubmissionPlan submission_plan) {
    FramePlan plan;
    plan.boundary = boundary_states(graph, live, sync);
    plan.graph = std::move(graph);
    plan.live = std::move(live);
    plan.schedule = std::move(order);
    plan.lifetimes = std::move(spans);
    plan.memory = std::move(memory);
    plan.barriers = std::move(barrier_plan);
    plan.submissions = std::move(submission_plan);
    plan.hash = plan_hash(plan);
    return plan;
}

}  // namespace weft
