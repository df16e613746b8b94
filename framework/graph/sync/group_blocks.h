// Purpose: finds the block of each group in the schedule. A group is a set of passes that runs in rounds;
// each round is one copy of all passes of the group. The block is the range of schedule positions in which
// the passes of the group run, one after another on one queue, round by round. A frame may run the rounds in
// another order or leave some out. So everything that is not part of a round (semaphore waits, and barriers
// of resources that no round writes) stands before or after the whole block.
#pragma once

#include <vector>

#include "weft/plan.h"

namespace weft {

// The schedule positions of the passes of a group: from `first` to `last`, inclusive. Empty if first > last:
// all passes of the group were culled.
struct GroupBlock {
    Position first = 1;
    Position last = 0;

    [[nodiscard]] bool empty() const { return first > last; }
    [[nodiscard]] bool contains(Position position) const { return position >= first && position <= last; }
};

// Returns the block of each group (the schedule positions of its passes), in the order of
// ResolvedGraph::groups.
[[nodiscard]] std::vector<GroupBlock> group_blocks(const ResolvedGraph& graph, const Schedule& order);

// Moves each dependency to the borders of the blocks (the ranges of positions of the groups). If a pass in a
// block waits, the first pass of the block waits instead. If a pass waits for a pass in a block, it waits for
// the last pass of the block instead.
[[nodiscard]] std::vector<QueueDependency> outside_blocks(const std::vector<GroupBlock>& blocks,
                                                          std::vector<QueueDependency> dependencies);
// Moves the barriers that are recorded in every frame to the borders of the blocks (the ranges of positions
// of the groups). Barriers before a pass move to the first step of its block, and barriers after a pass move
// to the last step.
void move_shared_barriers(const std::vector<GroupBlock>& blocks, BarrierPlan& plan);

}  // namespace weft
