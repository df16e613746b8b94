// Purpose: computes the memory accesses of a pass through one of its uses, including the load and store
// operations of attachments, and what these operations do to the content.
#pragma once

#include "weft/plan.h"

namespace weft::null {

struct EffectiveUse {
    StageMask stages = stage::kNone;
    AccessMask access = access::kNone;
    bool reads = false;  // True if at least some previous content is read.
    // True if memory is written, even if a store operation only writes the previous content back.
    bool writes = false;
    // True if the pass needs the previous content or a clear, but the load operation gives neither.
    bool loses_old = false;
    bool loses_written = false;  // True if the content is undefined after the pass: it is not stored.
};
// Returns true if the use is an attachment. In these functions, `use` and `index` are indices into
// PassDecl::uses.
[[nodiscard]] bool draws_to(const PassDecl& pass, uint32_t use);
[[nodiscard]] EffectiveUse effective_use(const PassDecl& pass, const PassStep& step, uint32_t use);

// Returns one of `stages`, selected by the number `choice`; kNone if there are no stages. A use may have
// several stages. The simulation lets one of them write, because the plan does not tell which stage writes.
[[nodiscard]] StageMask drawn_stage(StageMask stages, uint64_t choice);
[[nodiscard]] inline StageMask write_stage(const EffectiveUse& use, Position position, uint32_t index,
                                           uint64_t choice) {
    return drawn_stage(use.stages, choice + position + index);
}

}  // namespace weft::null
