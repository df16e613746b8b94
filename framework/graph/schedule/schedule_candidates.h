// Purpose: computes the candidate orders of passes from which schedule() chooses, and the cost of each order.
// Units: bytes of transient memory. Run time: O((passes + edges + uses) log passes), because the algorithms
// keep the ready passes in a heap.
// Source: greedy list scheduling for memory, as in AMD's Render Pipeline Shaders SDK. Program order is a
// candidate too, because no single heuristic is best for all graphs.
#pragma once

#include <cstdint>
#include <vector>

#include "graph/model/rows.h"
#include "weft/plan.h"

namespace weft {

// The part of a graph that the scheduling algorithms need. A culled pass stays in it as a node without cost.
// This keeps indirect orders: if a culled pass b runs after a, and c after b, then c still runs after a.
struct ScheduleProblem {
    std::vector<uint8_t> live;  // Index: PassId. 1 if the pass is live, 0 if it is culled.
    // Index: PassId. Rank of the pass when passes are sorted by (order_key, name).
    std::vector<uint32_t> rank;
    // One row per pass. `successors`: the passes that depend on the pass. `predecessors`: the passes on which
    // it depends.
    Rows<PassId> successors, predecessors;
    Rows<ResourceId> resources;  // One row per pass: the transients that it uses, without duplicates.
    Rows<PassId> users;          // One row per resource: the live passes that use it, without duplicates.
    std::vector<uint64_t> size_bytes;  // Index: ResourceId. Size of the resource in bytes.
};

[[nodiscard]] ScheduleProblem schedule_problem(const ResolvedGraph& graph, const LiveGraph& live,
                                               const MemoryNeeds& needs);

// Returns a topological order of the live passes. Among the passes whose predecessors are all in the order
// already, the pass with the lowest ScheduleProblem::rank comes first.
[[nodiscard]] std::vector<PassId> program_order(const ScheduleProblem& problem);
// Returns the order that a greedy algorithm finds from the first pass to the last. The next pass is always
// the ready pass with the lowest value of: bytes that it allocates, minus bytes that it frees.
[[nodiscard]] std::vector<PassId> forward_greedy_order(const ScheduleProblem& problem);
// Returns the order that the greedy algorithm of forward_greedy_order() finds when it starts at the last pass
// and goes backwards in time.
[[nodiscard]] std::vector<PassId> backward_greedy_order(const ScheduleProblem& problem);

[[nodiscard]] uint64_t peak_live_bytes(const ScheduleProblem& problem, const std::vector<PassId>& order);
// Returns how many barriers the order needs if every barrier waits for all earlier work. A pass needs a
// barrier before it in two cases: it uses a transient for the first time in the frame, or one of its
// predecessors runs after the latest barrier.
[[nodiscard]] uint32_t barrier_batches(const ScheduleProblem& problem, const std::vector<PassId>& order);

}  // namespace weft
