#include "graph/sync/accesses.h"

#include <numeric>

namespace weft {
namespace {

// Adds the memory accesses of an attachment's load and store operations to the event. The operation DONT_CARE
// counts as a write, as in the Vulkan specification.
void add_attachment_access(const AttachmentOps& ops, const UseDecl& use, AccessEvent& event) {
    const bool depth = (use.range.aspects & (aspect::kDepth | aspect::kStencil)) != 0;
    const AccessMask read = depth ? access::kDepthStencilRead : access::kColorRead;
    const AccessMask write = depth ? access::kDepthStencilWrite : access::kColorWrite;
    if (ops.load == LoadOp::load) event.state.access |= read;
    const bool discards = ops.load == LoadOp::dont_care || ops.store == StoreOp::dont_care;
    const bool stores = ops.load == LoadOp::clear || ops.store == StoreOp::store;
    if (!discards && !stores) return;
    event.state.access |= write;
    event.writes = true;
}

}  // namespace

void append_access(const AccessEvent& event, std::vector<AccessEvent>& accesses) {
    if (accesses.empty() || accesses.back().position != event.position) {
        accesses.push_back(event);
        return;
    }
    AccessEvent& same = accesses.back();
    same.state.stages |= event.state.stages;
    same.state.access |= event.state.access;
    same.writes = same.writes || event.writes;
    same.reads = same.reads || event.reads;
    if (event.merged_position != same.merged_position) same.merged_position = kNoId;
}

AccessTable collect_accesses(const ResolvedGraph& graph, const Schedule& order,
                             const AttachmentTable& attachments, const std::vector<Position>& scopes) {
    AccessTable table;
    table.offsets.assign(graph.resources.size() + 1, 0);
    for (const PassId id : order.order)
        for (const UseDecl& use : graph.passes[id].uses) ++table.offsets[use.resource + 1];
    std::partial_sum(table.offsets.begin(), table.offsets.end(), table.offsets.begin());
    table.items.resize(table.offsets.back());
    std::vector<uint32_t> next(table.offsets.begin(), table.offsets.end() - 1);
    for (Position position(0); position < order.order.size(); ++position) {
        const PassId id = order.order[position];
        const PassDecl& pass = graph.passes[id];
        for (uint32_t u = 0; u < pass.uses.size(); ++u) {
            const UseDecl& use = pass.uses[u];
            RangeAccess& access = table.items[next[use.resource]++];
            access = {
                use.range,
                {position, id, order.queue[position], use.state, writes(use.access), reads(use.access)}};
            for (const AttachmentOps& ops : attachments[position]) {
                if (ops.use != u) continue;
                add_attachment_access(ops, use, access.event);
                access.event.merged_position = scopes[position];
            }
        }
    }
    return table;
}

}  // namespace weft
