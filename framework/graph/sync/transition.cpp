#include "weft/transition.h"

#include <algorithm>
#include <string>

#include "weft/format.h"

namespace weft {
namespace {

enum class ContentAction : uint8_t { clear, copy, resample };

bool same_shape(const ResourceDecl& a, const ResourceDecl& b) {
    return a.extent == b.extent && a.mips == b.mips && a.layers == b.layers && a.size_bytes == b.size_bytes;
}

// Decides how a resource of the new plan gets its first content: from the old plan's resource of the same
// name, copied or scaled to the new size, or by a clear.
ContentAction choose_action(const ResourceDecl& old_decl, const ResourceDecl& decl) {
    const bool same_kind = old_decl.lifetime == ResourceLifetime::persistent && old_decl.kind == decl.kind &&
                           old_decl.format == decl.format && old_decl.image_kind == decl.image_kind &&
                           old_decl.samples == decl.samples;
    if (!same_kind) return ContentAction::clear;
    if (same_shape(old_decl, decl)) return ContentAction::copy;
    // Only single-sampled colour images can be scaled to a new size. A buffer has no width and height, and an
    // average of depths is meaningless.
    const bool blends = decl.kind == ResourceKind::image && decl.layers == old_decl.layers &&
                        decl.samples == 1 && (decl.aspects & aspect::kColor) != 0;
    return decl.on_resize == OnResize::resample && blends ? ContentAction::resample : ContentAction::clear;
}

AccessState transfer_state(const ResourceDecl& decl, Access access) {
    return access_state(access, 0, decl.kind == ResourceKind::image ? decl.aspects : aspect::kNone);
}

AccessState everything(Layout layout) {
    constexpr AccessMask kHostAccess = access::kHostRead | access::kHostWrite;
    return {stage::kAll & ~stage::kHost, access::kAll & ~kHostAccess, layout};
}

class Builder {
 public:
    Builder(const FramePlan& old_plan, const FramePlan& new_plan) : old_(old_plan), new_(new_plan) {
        plan_.keeps_validity.assign(new_plan.graph.resources.size(), 0);
    }

    TransitionPlan build() {
        for (const ResourceId id : new_.barriers.prologue.cleared) add(id);
        return std::move(plan_);
    }

 private:
    void add(ResourceId id) {
        const ResourceDecl& decl = new_.graph.resources[id];
        const ResourceId from = find_content(decl);
        const bool lived = from != kNoId && old_.live.live_resources[from] != 0;
        const ContentAction action =
            lived ? choose_action(old_.graph.resources[from], decl) : ContentAction::clear;
        // The first new frame overwrites the ring's resource of age 0, so its old content is not needed.
        const bool forgotten = decl.history > 0 && decl.age == 0;
        AccessState written = transfer_state(decl, Access::clear_write);
        if (action == ContentAction::clear || forgotten) {
            plan_.cleared.push_back(id);
        } else {
            written =
                transfer_state(decl, action == ContentAction::copy ? Access::copy_write : Access::blit_write);
            plan_.carried.push_back({from, id, action == ContentAction::resample});
            leave_old(from, transfer_state(
                                decl, action == ContentAction::copy ? Access::copy_read : Access::blit_read));
        }
        if (action != ContentAction::clear && decl.ring != kNoId) plan_.keeps_validity[decl.ring] = 1;
        enter_new(id, written);
    }

    // Returns the resource of the old plan whose content the new resource continues, or kNoId. Between two
    // frames, a resource with `history` has the content of the last frame in its copy of age 1. A resource
    // with `keep` alone has it in its only copy.
    [[nodiscard]] ResourceId find_content(const ResourceDecl& decl) const {
        if (decl.ring == kNoId) return kNoId;
        const ResourceId ring = find_resource(old_.graph, new_.graph.resources[decl.ring].name);
        if (ring == kNoId) return kNoId;
        const uint32_t old_history = old_.graph.resources[ring].history;
        if ((old_history > 0) == (decl.history > 0)) return find_resource(old_.graph, decl.name);
        if (old_history == 0) return decl.age == 1 ? ring : kNoId;
        const auto last = std::ranges::find_if(old_.graph.resources, [&](const ResourceDecl& old) {
            return old.ring == ring && old.age == 1;
        });
        return static_cast<ResourceId>(last - old_.graph.resources.begin());
    }

    void leave_old(ResourceId from, const AccessState& read) {
        for (const BoundaryState& state : old_.boundary) {
            if (state.resource != from) continue;
            BarrierDecl barrier;
            barrier.resource = from;
            barrier.range = state.range;
            barrier.src = everything(state.state.layout);
            barrier.dst = read;
            barrier.reason = BarrierReason::prologue;
            plan_.before_old.push_back(barrier);
        }
    }

    void enter_new(ResourceId id, const AccessState& written) {
        const ResourceDecl& decl = new_.graph.resources[id];
        BarrierDecl barrier;
        barrier.resource = id;
        barrier.range = decl.whole();
        barrier.dst = written;
        barrier.reason = BarrierReason::prologue;
        if (decl.kind == ResourceKind::image) plan_.before.push_back(barrier);
        for (BarrierDecl after : new_.barriers.prologue.after) {
            if (after.resource != id) continue;
            after.src = written;
            plan_.after.push_back(after);
        }
    }

    const FramePlan& old_;
    const FramePlan& new_;
    TransitionPlan plan_;
};

}  // namespace

TransitionPlan transition(const FramePlan& old_plan, const FramePlan& new_plan) {
    return Builder(old_plan, new_plan).build();
}

}  // namespace weft
