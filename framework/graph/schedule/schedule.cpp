// Chooses the best of three candidate orders: the one with the lowest peak of live memory, and at equal peaks
// the one with the fewest barrier batches. One candidate is the program order (the author's order), so the
// chosen order is never worse than the author's. If another order is only as good, the program order wins.
#include <algorithm>
#include <cassert>
#include <tuple>
#include <utility>

#include "graph/schedule/gather_groups.h"
#include "graph/schedule/queue_assign.h"
#include "graph/schedule/schedule.h"
#include "graph/schedule/schedule_candidates.h"

namespace weft {
namespace {

struct NamedOrder {
    const char* name;
    std::vector<PassId> order;
};

bool better(const ScheduleCandidate& a, const ScheduleCandidate& b) {
    return std::tie(a.peak_live_bytes, a.barrier_batches, a.queue_switches) <
           std::tie(b.peak_live_bytes, b.barrier_batches, b.queue_switches);
}

// Returns true if each pass depends on the pass before it. Then no other order of the passes is possible.
bool is_only_order(const ScheduleProblem& problem, const std::vector<PassId>& order) {
    for (size_t i = 1; i < order.size(); ++i)
        if (std::ranges::find(problem.predecessors[order[i]], order[i - 1]) ==
            problem.predecessors[order[i]].end())
            return false;
    return true;
}

}  // namespace

Schedule schedule(const ResolvedGraph& graph, const LiveGraph& live, const MemoryNeeds& needs,
                  const std::vector<LogicalQueue>& queues) {
    const ScheduleProblem problem = schedule_problem(graph, live, needs);
    const std::vector<PassId> program = program_order(problem);
    const bool only = is_only_order(problem, program);
    NamedOrder candidates[] = {{"program", program},
                               {"forward", only ? program : forward_greedy_order(problem)},
                               {"backward", only ? program : backward_greedy_order(problem)}};
    if (!graph.groups.empty())
        for (NamedOrder& candidate : candidates)
            candidate.order = gather_groups(graph, problem, candidate.order);
    Schedule result;
    size_t best = 0;
    for (size_t i = 0; i < std::size(candidates); ++i) {
        const std::vector<PassId>& order = candidates[i].order;
        assert(order.size() == candidates[0].order.size() && "edges are acyclic");
        if (i > 0 && order == candidates[i - 1].order) {
            result.candidates.push_back(result.candidates[i - 1]);
            result.candidates[i].name = candidates[i].name;
            continue;
        }
        result.candidates.push_back(
            {candidates[i].name, peak_live_bytes(problem, order), barrier_batches(problem, order), 0});
        if (better(result.candidates[i], result.candidates[best])) best = i;
    }
    result.chosen = candidates[best].name;
    result.order = std::move(candidates[best].order);
    result.position.assign(graph.passes.size(), kNoId);
    for (Position p(0); p < result.order.size(); ++p) result.position[result.order[p]] = p;
    result.queues = queues;
    result.queue = assign_queues(graph, result.order, queues);
    return result;
}

}  // namespace weft
