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
// Returns the keys of a group, such as: 6 rounds, 2 per frame, 4 per frame until all have run, turns from
// "wanted", rest, settle 1.
[[nodiscard]] std::string describe_group(const GroupDecl& group);
// Returns sentences that tell when a round of the group has its turn.
[[nodiscard]] std::string describe_turns(const GroupDecl& group);
// Returns the block of the group around this position; empty if the pass there belongs to no group. Barriers
// that are recorded in every frame stand before its first pass or after its last pass.
[[nodiscard]] GroupBlock block_around(const FramePlan& plan, Position position);

}  // namespace weft
