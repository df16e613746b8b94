#include "null/effective_use.h"

#include <algorithm>
#include <bit>

#include "null/cells.h"

namespace weft::null {
namespace {

const AttachmentDecl* attachment_of(const PassDecl& pass, uint32_t use) {
    for (const AttachmentDecl& color : pass.colors)
        if (color.use == use) return &color;
    return pass.depth && pass.depth->use == use ? &*pass.depth : nullptr;
}

void apply_operations(const AttachmentOps& ops, const AttachmentDecl* attachment, const UseDecl& use,
                      EffectiveUse& effective) {
    const bool color = (use.state.stages & stage::kColorOutput) != 0;
    const bool wants_old = reads(use.access), changes = writes(use.access);
    const bool covers = attachment != nullptr && attachment->covers;
    if (ops.load == LoadOp::load) {
        effective.access |= color ? access::kColorRead : access::kDepthStencilRead;
        effective.reads = true;
    }
    const bool begins_with_write = ops.load == LoadOp::clear || ops.load == LoadOp::dont_care;
    if (begins_with_write || ops.store != StoreOp::none) {
        effective.access |= color ? access::kColorWrite : access::kDepthStencilWrite;
        effective.writes = true;
    }
    effective.loses_old =
        wants_old ? ops.load != LoadOp::load : changes && !covers && ops.load != LoadOp::clear;
    effective.loses_written =
        changes ? ops.store != StoreOp::store : begins_with_write || ops.store == StoreOp::dont_care;
}

}  // namespace

bool draws_to(const PassDecl& pass, uint32_t use) {
    return attachment_of(pass, use) != nullptr;
}

EffectiveUse effective_use(const PassDecl& pass, const PassStep& step, uint32_t index) {
    const UseDecl& use = pass.uses[index];
    EffectiveUse effective;
    effective.stages = use.state.stages;
    effective.access = use.state.access;
    effective.reads = sees_content(use);
    effective.writes = writes(use.access);
    const auto ops = std::find_if(step.attachments.begin(), step.attachments.end(),
                                  [index](const AttachmentOps& o) { return o.use == index; });
    if (ops != step.attachments.end()) apply_operations(*ops, attachment_of(pass, index), use, effective);
    return effective;
}

StageMask drawn_stage(StageMask stages, uint64_t choice) {
    if (stages == stage::kNone) return stage::kNone;
    uint64_t skip = choice % static_cast<uint64_t>(std::popcount(stages));
    for (; skip > 0; --skip) stages &= stages - 1;
    return stages & (~stages + 1);
}

}  // namespace weft::null
