#include <utility>

#include "graph/stages.h"
#include "weft/compile.h"

namespace weft {
namespace {

// Entry and exit describe the same point between two frames, so that the exit state is what is left there.
std::vector<BoundaryState> boundary_states(const ResolvedGraph& graph, const LiveGraph& live) {
    std::vector<BoundaryState> states;
    for (ResourceId id = 0; id < graph.resources.size(); ++id) {
        const ResourceDecl& resource = graph.resources[id];
        if (live.live_resources[id] && resource.import)
            states.push_back({id, resource.whole(), resource.import->exit, resource.import->family});
    }
    return states;
}

}  // namespace

FramePlan link(ResolvedGraph graph, LiveGraph live, Schedule order, Lifetimes spans, MemoryPlan memory,
               BarrierPlan barrier_plan, SubmissionPlan submission_plan) {
    FramePlan plan;
    plan.boundary = boundary_states(graph, live);
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
