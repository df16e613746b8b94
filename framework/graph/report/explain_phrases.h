// Purpose: the parts that explanations are made of, for a page that shows them all at once.
#pragma once

#include <string>
#include <vector>

#include "weft/plan.h"

namespace weft {

[[nodiscard]] const char* describe_reason(BarrierReason reason);  // "a read after a write"
// Uses of the memory that a barrier is about: of its resource, or of whoever held the memory before.
[[nodiscard]] std::vector<const UseDecl*> uses_waited_for(const FramePlan& plan, const BarrierDecl& barrier,
                                                          PassId pass);
[[nodiscard]] bool waits_for(const FramePlan& plan, const BarrierDecl& barrier, PassId pass);

[[nodiscard]] std::string describe_batch(const FramePlan& plan,
                                         const Batch& batch);  // queue 0, 1 "a" to 3 "b"
// Indented lines: which pass must not start before which, and their uses. kNoId: empty.
[[nodiscard]] std::string describe_cause(const FramePlan& plan, uint32_t dependency);

// Indented lines: who takes over whose memory and when, or that a third one comes between.
[[nodiscard]] std::string describe_alias_transitions(const FramePlan& plan, ResourceId a, ResourceId b);

}  // namespace weft
