#include "weft/transition.h"

#include <algorithm>
#include <optional>
#include <string>

#include "weft/format.h"

namespace weft {
namespace {

enum class ContentAction : uint8_t { clear, copy, resample, share };

bool same_shape(const ResourceDecl& a, const ResourceDecl& b) {
    return a.extent == b.extent && a.mips == b.mips && a.layers == b.layers && a.size_bytes == b.size_bytes;
}

// Returns true if a blit can write the content of one image to the other. Depth images cannot be blitted,
// because an average of depths is meaningless. If the formats differ, both must hold floats or normalised
// numbers. resolve() has checked that the device can blit the formats of images with "onResize": "resample".
bool can_blit(const ResourceDecl& from, const ResourceDecl& to) {
    const auto is_float = [](const ResourceDecl& d) {
        return format_info(d.format).numeric == NumericClass::float_like;
    };
    const bool formats =
        from.format == to.format || (is_float(from) && is_float(to) && from.on_resize == OnResize::resample);
    return to.on_resize == OnResize::resample && to.kind == ResourceKind::image && from.layers == to.layers &&
           to.samples == 1 && (to.aspects & aspect::kColor) != 0 && formats;
}

bool same_kind(const ResourceDecl& old_decl, const ResourceDecl& decl) {
    return old_decl.lifetime == ResourceLifetime::persistent && old_decl.kind == decl.kind &&
           old_decl.image_kind == decl.image_kind && old_decl.samples == decl.samples;
}

// Passes use only a part of an image with a live size, its area. So an old image with a live size may have
// content only in its area, and a new image without a live size cannot copy it.
bool can_copy(const ResourceDecl& old_decl, const ResourceDecl& decl) {
    const bool only_area = old_decl.area != kNoId && decl.area == kNoId;
    return same_shape(old_decl, decl) && old_decl.format == decl.format && !only_area;
}

// Decides how a resource of the new plan gets its first content. Either it continues the content of the old
// plan's resource: in the same memory, as a copy, or scaled and converted. Or it is cleared.
ContentAction choose_action(const ResourceDecl& old_decl, const ResourceDecl& decl) {
    if (!same_kind(old_decl, decl)) return ContentAction::clear;
    if (shares_memory(old_decl, decl)) return ContentAction::share;
    if (can_copy(old_decl, decl)) return ContentAction::copy;
    return can_blit(old_decl, decl) ? ContentAction::resample : ContentAction::clear;
}

// Returns the mips and layers that both ranges have, or nullopt if there are none.
std::optional<SubresourceRange> common_part(const SubresourceRange& a, const SubresourceRange& b) {
    if (!overlaps(a, b)) return std::nullopt;
    SubresourceRange part;
    part.mip = std::max(a.mip, b.mip);
    part.mips = std::min(a.mip + a.mips, b.mip + b.mips) - part.mip;
    part.layer = std::max(a.layer, b.layer);
    part.layers = std::min(a.layer + a.layers, b.layer + b.layers) - part.layer;
    part.aspects = a.aspects & b.aspects;
    return part;
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
        if (action != ContentAction::clear && decl.ring != kNoId) plan_.keeps_validity[decl.ring] = 1;
        // The first new frame overwrites the copy of age 0, so the old content of this copy is not needed.
        const bool forgotten = decl.history > 0 && decl.age == 0;
        if (action == ContentAction::clear || forgotten) {
            plan_.cleared.push_back(id);
            enter_new(id, transfer_state(decl, Access::clear_write));
        } else if (action == ContentAction::share) {
            plan_.carried.push_back({from, id, false, true});
            pass_on(from, id);
        } else {
            const bool blits = action == ContentAction::resample;
            plan_.carried.push_back({from, id, blits});
            leave_old(from, transfer_state(decl, blits ? Access::blit_read : Access::copy_read));
            enter_new(id, transfer_state(decl, blits ? Access::blit_write : Access::copy_write));
        }
    }

    // Brings shared memory from the states in which the old plan leaves it to those that the new plan
    // expects.
    void pass_on(ResourceId from, ResourceId id) {
        for (const BoundaryState& state : old_.boundary) {
            if (state.resource != from) continue;
            for (BarrierDecl after : new_.barriers.prologue.after) {
                if (after.resource != id) continue;
                // The two plans may divide a buffer into different pieces. A buffer has no layouts, so the
                // first old piece is enough, and the others are skipped.
                const bool buffer = new_.graph.resources[id].kind == ResourceKind::buffer;
                if (buffer && state.range.layer > 0) continue;
                const std::optional<SubresourceRange> part =
                    buffer ? after.range : common_part(state.range, after.range);
                if (!part) continue;
                after.range = *part;
                after.src = everything(state.state.layout);
                plan_.after.push_back(after);
            }
        }
    }

    // Returns the resource of the old plan whose content the new resource continues, or kNoId. Between two
    // frames, a resource with `history` has the content of the last frame in its copy of age 1. A resource
    // with `keep` but without `history` has this content in its only copy.
    [[nodiscard]] ResourceId find_content(const ResourceDecl& decl) const {
        if (decl.ring == kNoId) return kNoId;
        const ResourceId ring = find_resource(old_.graph, new_.graph.resources[decl.ring].name);
        if (ring == kNoId) return kNoId;
        const uint32_t old_history = old_.graph.resources[ring].history;
        if ((old_history > 0) == (decl.history > 0)) return find_resource(old_.graph, decl.name);
        if (old_history == 0) return decl.age == 1 ? ring : kNoId;
        const auto last = std::ranges::find_if(
            old_.graph.resources, [&](const ResourceDecl& old) { return old.ring == ring && old.age == 1; });
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
        // Frames of an even older plan may still use shared memory, so the barrier waits for everything.
        if (decl.shared) barrier.src = everything(Layout::undefined);
        barrier.dst = written;
        barrier.reason = BarrierReason::prologue;
        if (decl.kind == ResourceKind::image || decl.shared) plan_.before.push_back(barrier);
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

std::string size_text(const ResourceDecl& decl) {
    if (decl.kind == ResourceKind::buffer) return std::to_string(decl.size_bytes) + " bytes";
    return std::to_string(decl.extent.width) + "x" + std::to_string(decl.extent.height) + ", " +
           std::to_string(decl.mips) + " mips, " + std::to_string(decl.layers) + " layers";
}

std::string difference_text(const ResourceDecl& from, const ResourceDecl& to) {
    std::string text;
    if (from.format != to.format)
        text += " from " + std::string(format_info(from.format).name) + " to " +
                std::string(format_info(to.format).name);
    if (!same_shape(from, to))
        text += std::string(text.empty() ? "" : ",") + " from " + size_text(from) + " to " + size_text(to);
    if (from.area != kNoId && to.area == kNoId)
        text += std::string(text.empty() ? "" : ",") + " from a live size to a fixed size";
    return text;
}

}  // namespace

std::string content_text(const FramePlan& old_plan, const FramePlan& new_plan,
                         const TransitionPlan& transition, ResourceId id) {
    const ResourceDecl& decl = new_plan.graph.resources[id];
    const std::string name = "\"" + new_plan.graph.resources[decl.ring].name + "\"";
    const auto found = std::ranges::find(transition.carried, id, &ContentCopy::to);
    if (found != transition.carried.end()) {
        const ResourceDecl& from = old_plan.graph.resources[found->from];
        if (found->shared) return name + " keeps its memory";
        if (!found->resample) return name + " is copied";
        return name + (from.format != decl.format ? " is converted" : " is scaled") +
               difference_text(from, decl);
    }
    if (new_plan.live.live_resources[id] == 0) return name + " is freed: no pass of the new plan uses it";
    const ResourceId from = find_resource(old_plan.graph, decl.name);
    if (from == kNoId || old_plan.live.live_resources[from] == 0)
        return name + " is cleared: the old plan does not have it";
    const std::string difference = difference_text(old_plan.graph.resources[from], decl);
    return name + " is cleared: " +
           (difference.empty() ? "its kind or its number of samples differs"
                               : "it changes" + difference + ", and cannot be scaled or converted");
}

bool shares_memory(const ResourceDecl& old_decl, const ResourceDecl& decl) {
    return same_kind(old_decl, decl) && can_copy(old_decl, decl) && old_decl.shared && decl.shared &&
           old_decl.usage == decl.usage;
}

TransitionPlan transition(const FramePlan& old_plan, const FramePlan& new_plan) {
    return Builder(old_plan, new_plan).build();
}

}  // namespace weft
