// Purpose: the orders that schedule() chooses from, and what each would cost.
// Units: bytes of transient memory. Costs: heaps throughout, O((passes + edges + uses) log passes).
// Source: greedy list scheduling for memory, as in AMD's Render Pipeline Shaders SDK, with program order
// beside it because no single heuristic wins everywhere.
#pragma once

#include <cstdint>
#include <vector>

#include "weft/plan.h"

namespace weft {

// Rows of indices, stored flat.
struct IndexRows {
    std::vector<uint32_t> offsets;  // row r is items [offsets[r], offsets[r + 1])
    std::vector<uint32_t> items;

    [[nodiscard]] const uint32_t* begin(uint32_t row) const { return items.data() + offsets[row]; }
    [[nodiscard]] const uint32_t* end(uint32_t row) const { return items.data() + offsets[row + 1]; }
};

// The part of a graph that the candidates need. Culled passes stay as nodes without cost, so that an order
// which only runs through them ("a after b after c") still holds.
struct ScheduleProblem {
    std::vector<uint8_t> live;           // by pass
    std::vector<uint32_t> rank;          // by pass: its place by (order_key, name)
    IndexRows successors, predecessors;  // by pass
    IndexRows resources;                 // by pass: transients it touches, each once; live passes only
    IndexRows users;                     // by resource: live passes, each once
    std::vector<uint64_t> size_bytes;    // by resource
};

[[nodiscard]] ScheduleProblem schedule_problem(const ResolvedGraph& graph, const LiveGraph& live,
                                               const MemoryNeeds& needs);

// Topological by rank.
[[nodiscard]] std::vector<PassId> program_order(const ScheduleProblem& problem);
// Always the ready pass that allocates least, after what it frees.
[[nodiscard]] std::vector<PassId> forward_greedy_order(const ScheduleProblem& problem);
// The same from the last pass to the first.
[[nodiscard]] std::vector<PassId> backward_greedy_order(const ScheduleProblem& problem);

[[nodiscard]] uint64_t peak_live_bytes(const ScheduleProblem& problem, const std::vector<PassId>& order);
// Positions that need a barrier, were every barrier a full one: those that touch a transient first, or depend
// on a pass since the last such position.
[[nodiscard]] uint32_t barrier_batches(const ScheduleProblem& problem, const std::vector<PassId>& order);

}  // namespace weft
