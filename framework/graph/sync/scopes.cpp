#include "graph/sync/scopes.h"

#include <algorithm>

namespace weft {
namespace {

bool draws(const PassDecl& pass) {
    // A pass with frame slices, a rest unit or a switch does not run in every frame, so it cannot share a
    // rendering scope.
    return (pass.kind == PassKind::raster || pass.kind == PassKind::fullscreen) && pass.frame_slices == 0 &&
           pass.rest_unit == kNoId && pass.switch_id == kNoId;
}

// Returns the colour attachments sorted by location, then the depth attachment.
std::vector<const AttachmentDecl*> attachments_of(const PassDecl& pass) {
    std::vector<const AttachmentDecl*> all;
    for (const AttachmentDecl& color : pass.colors) all.push_back(&color);
    if (pass.depth) all.push_back(&*pass.depth);
    return all;
}

// Returns true if the second pass can draw to its attachment `b` in the same rendering scope in which the
// first pass draws to its attachment `a`. Location, subresource and layout must be the same. There must be no
// resolve, and the second pass must read the old content. Both passes must write the attachment, or neither
// of them, because the scope has the load operation of its first pass and the store operation of its last.
bool keeps_attachment(const PassDecl& first, const AttachmentDecl& a, const PassDecl& second,
                      const AttachmentDecl& b) {
    const UseDecl &before = first.uses[a.use], &after = second.uses[b.use];
    return a.location == b.location && a.resolve_use == kNoId && b.resolve_use == kNoId &&
           before.resource == after.resource && before.range == after.range &&
           before.state.layout == after.state.layout && reads(after.access) &&
           writes(before.access) == writes(after.access);
}

bool is_attachment(const PassDecl& pass, uint32_t use) {
    const std::vector<const AttachmentDecl*> all = attachments_of(pass);
    return std::any_of(all.begin(), all.end(), [use](const AttachmentDecl* a) { return a->use == use; });
}

// Returns true if the pass also accesses one of its attachments in another way, for example by sampling, and
// one of the two accesses writes. This is not allowed in a shared scope, because the scope orders only the
// attachment accesses of its draws.
bool uses_what_it_draws(const PassDecl& pass) {
    for (const AttachmentDecl* attachment : attachments_of(pass)) {
        const UseDecl& drawn = pass.uses[attachment->use];
        for (uint32_t u = 0; u < pass.uses.size(); ++u) {
            const UseDecl& use = pass.uses[u];
            if (is_attachment(pass, u) || use.resource != drawn.resource || !overlaps(use.range, drawn.range))
                continue;
            if (writes(use.access) || writes(drawn.access)) return true;
        }
    }
    return false;
}

bool merges_render_pass(const PassDecl& first, const PassDecl& second,
                        const std::vector<AttachmentOps>& second_ops) {
    if (!draws(first) || !draws(second) || first.render_extent != second.render_extent) return false;
    if (first.lowering != second.lowering) return false;
    if (first.colors.size() != second.colors.size() || first.depth.has_value() != second.depth.has_value())
        return false;
    const std::vector<const AttachmentDecl*> before = attachments_of(first), after = attachments_of(second);
    if (after.empty()) return false;
    for (size_t i = 0; i < after.size(); ++i)
        if (!keeps_attachment(first, *before[i], second, *after[i])) return false;
    const bool loads = std::all_of(second_ops.begin(), second_ops.end(),
                                   [](const AttachmentOps& ops) { return ops.load == LoadOp::load; });
    return loads && !uses_what_it_draws(first) && !uses_what_it_draws(second);
}

}  // namespace

ScopeTable find_scopes(const ResolvedGraph& graph, const Schedule& order,
                       const AttachmentTable& attachments) {
    ScopeTable scopes(order.order.size(), kNoId);
    std::vector<Position> last(order.queues.size(), kNoId);
    for (Position position(0); position < scopes.size(); ++position) {
        Position& before = last[order.queue[position]];
        if (before != kNoId && merges_render_pass(graph.passes[order.order[before]],
                                                  graph.passes[order.order[position]], attachments[position]))
            scopes[position] = before;
        before = position;
    }
    return scopes;
}

ScopeTable undivided(ScopeTable scopes, std::span<const PlacedBarrier> barriers) {
    // Index: position. 1 if barriers are recorded right after the pass.
    std::vector<uint8_t> ends(scopes.size(), 0);
    for (const PlacedBarrier& placed : barriers) {
        if (placed.position == kEpiloguePosition) continue;
        if (placed.after)
            ends[placed.position] = 1;
        else
            scopes[placed.position] = kNoId;
    }
    for (Position& before : scopes)
        if (before != kNoId && ends[before] != 0) before = kNoId;
    return scopes;
}

ScopeTable within_batches(ScopeTable scopes, const SubmissionPlan& submissions) {
    for (const Batch& batch : submissions.batches)
        if (!batch.positions.empty()) scopes[batch.positions.front()] = kNoId;
    return scopes;
}

PassId continued_pass(const FramePlan& plan, Position position) {
    if (!plan.barriers.steps[position].merges_render_pass) return kNoId;
    for (uint32_t before = position; before-- > 0;)
        if (plan.schedule.queue[before] == plan.schedule.queue[position]) return plan.schedule.order[before];
    return kNoId;
}

}  // namespace weft
