// Purpose: the memory accesses of a pass through one of its uses, including the load and store operations of
// attachments, and the effects of these operations on content.
#pragma once

#include "weft/plan.h"

namespace weft::null {

struct EffectiveUse {
    StageMask stages = stage::kNone;
    AccessMask access = access::kNone;
    bool reads = false;          // reads at least some of the previous content
    bool writes = false;         // writes memory, even if it only writes back the previous content
    bool loses_old = false;      // the pass needs the previous content or a clear, but has neither
    bool loses_written = false;  // the content is undefined after the pass
};
[[nodiscard]] bool draws_to(const PassDecl& pass, uint32_t use);  // true if the use is an attachment
[[nodiscard]] EffectiveUse effective_use(const PassDecl& pass, const PassStep& step, uint32_t use);

// A use with several stages writes in one of them, which is not known: one is picked pseudo-randomly from
// `choice`.
[[nodiscard]] StageMask drawn_stage(StageMask stages, uint64_t choice);
[[nodiscard]] inline StageMask write_stage(const EffectiveUse& use, uint32_t position, uint32_t index,
                                           uint64_t choice) {
    return drawn_stage(use.stages, choice + position + index);
}

}  // namespace weft::null
