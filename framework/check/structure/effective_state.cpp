#include "check/structure/effective_state.h"

#include <algorithm>

namespace weft::check {

const AttachmentOps* ops_of(const PassStep& step, uint32_t use) {
    const auto it = std::find_if(step.attachments.begin(), step.attachments.end(),
                                 [use](const AttachmentOps& ops) { return ops.use == use; });
    return it == step.attachments.end() ? nullptr : &*it;
}

AccessState effective_state(const UseDecl& use, const AttachmentOps* ops) {
    AccessState state = use.state;
    if (!ops) return state;
    const bool color = (state.stages & stage::kColorOutput) != 0;
    const bool clears = ops->load == LoadOp::clear || ops->load == LoadOp::dont_care;
    if (ops->load == LoadOp::load) state.access |= color ? access::kColorRead : access::kDepthStencilRead;
    if (clears || ops->store != StoreOp::none)
        state.access |= color ? access::kColorWrite : access::kDepthStencilWrite;
    return state;
}

}  // namespace weft::check
