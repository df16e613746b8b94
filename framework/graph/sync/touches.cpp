#include "graph/sync/touches.h"

namespace weft {
namespace {

// Load and store operations touch an attachment too; DONT_CARE counts as a write.
void add_attachment_access(const AttachmentOps& ops, const UseDecl& use, Touch& touch) {
    const bool depth = (use.range.aspects & (aspect::kDepth | aspect::kStencil)) != 0;
    const AccessMask read = depth ? access::kDepthStencilRead : access::kColorRead;
    const AccessMask write = depth ? access::kDepthStencilWrite : access::kColorWrite;
    if (ops.load == LoadOp::load) touch.state.access |= read;
    const bool discards = ops.load == LoadOp::dont_care || ops.store == StoreOp::dont_care;
    const bool stores = ops.load == LoadOp::clear || ops.store == StoreOp::store;
    if (!discards && !stores) return;
    touch.state.access |= write;
    touch.writes = true;
}

}  // namespace

TouchTable collect_touches(const ResolvedGraph& graph, const Schedule& order,
                           const AttachmentTable& attachments, const std::vector<uint32_t>& scopes) {
    TouchTable touches(graph.resources.size());
    for (uint32_t position = 0; position < order.order.size(); ++position) {
        const PassId id = order.order[position];
        const PassDecl& pass = graph.passes[id];
        for (uint32_t u = 0; u < pass.uses.size(); ++u) {
            const UseDecl& use = pass.uses[u];
            Touch touch{position,         id, order.queue[position], use.state, writes(use.access),
                        reads(use.access)};
            for (const AttachmentOps& ops : attachments[position]) {
                if (ops.use != u) continue;
                add_attachment_access(ops, use, touch);
                touch.continues = scopes[position];
            }
            touches[use.resource].push_back({use.range, touch});
        }
    }
    return touches;
}

}  // namespace weft
