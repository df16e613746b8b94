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
[[nodiscard]] bool draws_to(const PassDecl& pass, uint32_t use);  // Returns true if the use is an attachment.
[[nodiscard]] EffectiveUse effective_use(const PassDecl& pass, const PassStep& step, uint32_t use);

// Picks one of `stages` pseudo-randomly from `choice`. It is used for a use with several stages, because only
// one of them writes and it is not known which.
[[nodiscard]] StageMask drawn_stage(StageMask stages, uint64_t choice);
[[nodiscard]] inline StageMask write_stage(const EffectiveUse& use, Position position, uint32_t index,
                                           uint64_t choice) {
    return drawn_stage(use.stages, choice + position + index);
}

}  // namespace weft::null
