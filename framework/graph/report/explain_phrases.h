// Purpose: builds the sentences that `weft explain` and the HTML page share.
#pragma once

#include <string>
#include <vector>

#include "weft/plan.h"

namespace weft {

// Returns a phrase such as "a read after a write".
[[nodiscard]] const char* describe_reason(BarrierReason reason);
// Returns the uses by `pass` that overlap the barrier's range of its resource. If the barrier takes over
// memory from other resources (`aliased_from`), returns the uses of these resources instead. Pipeline stages
// are not compared.
[[nodiscard]] std::vector<const UseDecl*> uses_waited_for(const FramePlan& plan, const BarrierDecl& barrier,
                                                          PassId pass);
// Returns true if the barrier waits for `pass`. If BarrierDecl::from is set, the barrier waits only for that
// pass. Otherwise the barrier waits for each pass that has a use with two properties: uses_waited_for()
// returns the use, and the use happens in one of the source stages of the barrier.
[[nodiscard]] bool waits_for(const FramePlan& plan, const BarrierDecl& barrier, PassId pass);

// Returns the queue, first pass and last pass of a batch, such as: queue 0, 1 "a" to 3 "b". The numbers
// before the names are schedule positions.
[[nodiscard]] std::string describe_batch(const FramePlan& plan, const Batch& batch);
// Returns indented lines that explain a dependency between queues. The first line tells which pass must not
// start before which other pass has finished. The next lines are the uses that are the reason. `dependency`
// is an index into SubmissionPlan::dependencies; for kNoId the text is empty.
[[nodiscard]] std::string describe_cause(const FramePlan& plan, uint32_t dependency);

// Returns one indented line for each time that `a` or `b` takes over memory from the other. The line names
// the schedule position. If there is no such time, the text says that a third resource uses the memory in
// between.
[[nodiscard]] std::string describe_alias_transitions(const FramePlan& plan, ResourceId a, ResourceId b);

}  // namespace weft
