// Purpose: describes the groups of a plan, for the texts and the page of the plan.
#pragma once

#include <string>

#include "graph/sync/group_blocks.h"
#include "weft/plan.h"

namespace weft {

// Returns the group to which the pass belongs; null if it belongs to none.
[[nodiscard]] const GroupDecl* group_of(const FramePlan& plan, PassId pass);
// Returns the name of the pass's round, such as: round 2 of group "relight".
[[nodiscard]] std::string describe_round(const FramePlan& plan, PassId pass);
// Returns a summary of the keys of a group, such as: 6 rounds, 2 per frame, 4 per frame until all have run,
// turns from "wanted", rest, settle 1.
[[nodiscard]] std::string describe_group(const GroupDecl& group);
// Returns sentences that tell in which frames a round of the group may run.
[[nodiscard]] std::string describe_turns(const GroupDecl& group);
// Returns the schedule positions of the first and last pass of the group to which the pass at `position`
// belongs. The result is empty if this pass belongs to no group. Barriers that are recorded in every frame
// stand before the first pass or after the last pass of the group.
[[nodiscard]] GroupBlock block_around(const FramePlan& plan, Position position);

}  // namespace weft
