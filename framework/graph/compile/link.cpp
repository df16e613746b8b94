#include <utility>

#include "graph/compile/link.h"

namespace weft {
namespace {

// Returns the states of persistent and imported resources between two frames. For an import this is the exit
// state, in which the frame leaves the import.
std::vector<BoundaryState> boundary_states(const ResolvedGraph& graph, const LiveGraph& live,
                                           const SyncTable& sync) {
    std::vector<BoundaryState> states;
    for (ResourceId id(0); id < graph.resources.size(); ++id) {
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

FramePlan link(StageResults results) {
    FramePlan plan;
    plan.boundary = boundary_states(results.graph, results.live, results.sync);
    plan.graph = std::move(results.graph);
    plan.live = std::move(results.live);
    plan.schedule = std::move(results.schedule);
    plan.lifetimes = std::move(results.lifetimes);
    plan.memory = std::move(results.memory);
    plan.barriers = std::move(results.barriers);
    plan.submissions = std::move(results.submissions);
    return plan;
}

}  // namespace weft
