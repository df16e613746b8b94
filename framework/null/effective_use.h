// Purpose: how a pass touches memory through one of its uses, once the load and store operations of
// attachments are counted in, and what these operations do to content.
#pragma once

#include "weft/plan.h"

namespace weft::null {

struct EffectiveUse {
    StageMask stages = stage::kNone;
    AccessMask access = access::kNone;
    bool reads = false;          // something of the old content is looked at
    bool writes = false;         // memory is written, if only with what was there
    bool loses_old = false;      // the pass needs the old content, or a clear, and gets neither
    bool loses_written = false;  // what is there after the pass is undefined
};
[[nodiscard]] bool draws_to(const PassDecl& pass, uint32_t use);  // as an attachment
[[nodiscard]] EffectiveUse effective_use(const PassDecl& pass, const PassStep& step, uint32_t use);

// A use of several stages writes in one of them, and nobody knows in which: drawn by `choice`.
[[nodiscard]] StageMask drawn_stage(StageMask stages, uint64_t choice);
[[nodiscard]] inline StageMask write_stage(const EffectiveUse& use, uint32_t position, uint32_t index,
                                           uint64_t choice) {
    return drawn_stage(use.stages, choice + position + index);
}

}  // namespace weft::null
