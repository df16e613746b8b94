#include "weft/check/check_transition.h"

#include <algorithm>
#include <string>
#include <vector>

#include "check/faults/fault_list.h"
#include "weft/format.h"

namespace weft {
namespace {

using check::FaultList;

constexpr StageMask kEveryStage = stage::kAll & ~stage::kHost;
constexpr AccessMask kEveryWrite = access::kAll & ~(access::kHostRead | access::kHostWrite);

// Returns true if each mip and layer of `range` has a barrier on `resource` for which `right` returns true.
template <class Right>
bool covered_by(const std::vector<BarrierDecl>& barriers, ResourceId resource, const SubresourceRange& range,
                Right right) {
    for (uint32_t mip = range.mip; mip < range.mip + range.mips; ++mip) {
        for (uint32_t layer = range.layer; layer < range.layer + range.layers; ++layer) {
            const SubresourceRange one{mip, 1, layer, 1, range.aspects};
            const bool found = std::any_of(barriers.begin(), barriers.end(), [&](const BarrierDecl& b) {
                return b.resource == resource && contains(b.range, one) && right(b);
            });
            if (!found) return false;
        }
    }
    return true;
}

class TransitionCheck {
 public:
    TransitionCheck(const FramePlan& old_plan, const FramePlan& new_plan, const TransitionPlan& transition)
        : old_(old_plan), new_(new_plan), transition_(transition), faults_(new_plan) {}

    Diagnostics run() {
        for (ResourceId id(0); id < new_.graph.resources.size(); ++id) {
            const ResourceDecl& decl = new_.graph.resources[id];
            if (decl.lifetime == ResourceLifetime::persistent && new_.live.live_resources[id])
                check_filled(id);
        }
        for (const ContentCopy& carry : transition_.carried) check_carried(carry);
        return faults_.take();
    }

 private:
    void add(const char* code, ResourceId id, const std::string& message, const std::string& help) {
        faults_.add(code, new_.graph.resources[id].loc, faults_.resource_name(id) + " " + message, help);
    }

    void check_filled(ResourceId id) {
        const auto times = std::count(transition_.cleared.begin(), transition_.cleared.end(), id) +
                           std::count_if(transition_.carried.begin(), transition_.carried.end(),
                                         [&](const ContentCopy& c) { return c.to == id; });
        if (times != 1)
            add("C370", id,
                "gets its content " + std::to_string(times) + " times in the transition, not once",
                "the transition must either copy each old content or clear the resource, once");
        if (is_shared(id)) return;
        const ResourceDecl& decl = new_.graph.resources[id];
        const bool image = decl.kind == ResourceKind::image;
        const AccessState writing = writing_state(id);
        const auto opens = [&](const BarrierDecl& b) {
            const bool waits = (kEveryStage & ~b.src.stages) == 0 && (kEveryWrite & ~b.src.access) == 0;
            return (waits || !decl.shared) && b.dst.layout == writing.layout &&
                   (writing.stages & ~b.dst.stages) == 0 && (writing.access & ~b.dst.access) == 0;
        };
        // A resource with `decl.shared` has the same memory in the plans of all tiers (quality levels). So
        // frames of plans before the old plan may still use this memory, and a barrier must wait for them.
        if ((image || decl.shared) && !covered_by(transition_.before, id, decl.whole(), opens))
            add("C371", id,
                decl.shared ? "is written while frames of earlier plans may still use its memory"
                            : "is written before a barrier changes its layout for the write",
                decl.shared ? "record a barrier from all stages before the write"
                            : "record a barrier from the undefined layout before the write");
        for (const BoundaryState& boundary : new_.boundary) {
            if (boundary.resource != id) continue;
            const auto closes = [&](const BarrierDecl& b) {
                return b.src.layout == writing.layout && (writing.stages & ~b.src.stages) == 0 &&
                       (writing.access & ~b.src.access) == 0 && (kEveryStage & ~b.dst.stages) == 0 &&
                       b.dst.layout == boundary.state.layout;
            };
            if (!covered_by(transition_.after, id, boundary.range, closes))
                add("C371", id,
                    "does not end in layout " + layout_text(boundary.state.layout) +
                        ", which the first frame expects",
                    "record a barrier from the writing stage to all stages after the write");
        }
    }

    [[nodiscard]] bool is_shared(ResourceId id) const {
        return std::ranges::any_of(transition_.carried,
                                   [&](const ContentCopy& c) { return c.to == id && c.shared; });
    }

    // Checks a resource of the new plan that takes over the memory of a resource of the old plan. Both plans
    // must declare the resource in the same way: kind, format, extent and so on. For each part of the
    // resource, a barrier must lead from the state at the end of an old frame to the state that the first new
    // frame expects.
    void check_shared(const ContentCopy& carry) {
        const ResourceDecl &from = old_.graph.resources[carry.from], &to = new_.graph.resources[carry.to];
        const bool same = from.name == to.name && from.kind == to.kind && from.format == to.format &&
                          from.image_kind == to.image_kind && from.extent == to.extent &&
                          from.mips == to.mips && from.layers == to.layers && from.samples == to.samples &&
                          from.size_bytes == to.size_bytes && from.usage == to.usage;
        if (!same || !from.shared || !to.shared || carry.resample || to.history != 0)
            add("C338", carry.to, "shares memory with a resource of the old plan that has another shape",
                "share the memory only if both plans declare the resource alike; otherwise copy the content");
        for (const BoundaryState& left : old_.boundary) {
            if (left.resource != carry.from) continue;
            for (const BoundaryState& wanted : new_.boundary)
                if (wanted.resource == carry.to) check_passed_on(carry.to, left, wanted);
        }
    }

    void check_passed_on(ResourceId id, const BoundaryState& left, const BoundaryState& wanted) {
        // A buffer has no layouts, and the two plans may divide it into different pieces. So only the range
        // of the new plan is checked.
        if (new_.graph.resources[id].kind == ResourceKind::buffer)
            return check_passed_on(id, left.state.layout, wanted, wanted.range);
        const uint32_t mips =
            std::min(left.range.mip + left.range.mips, wanted.range.mip + wanted.range.mips);
        const uint32_t layers =
            std::min(left.range.layer + left.range.layers, wanted.range.layer + wanted.range.layers);
        SubresourceRange part{std::max(left.range.mip, wanted.range.mip), 0,
                              std::max(left.range.layer, wanted.range.layer), 0,
                              static_cast<AspectMask>(left.range.aspects & wanted.range.aspects)};
        if (mips <= part.mip || layers <= part.layer || part.aspects == 0) return;
        part.mips = mips - part.mip;
        part.layers = layers - part.layer;
        check_passed_on(id, left.state.layout, wanted, part);
    }

    void check_passed_on(ResourceId id, Layout left, const BoundaryState& wanted,
                         const SubresourceRange& part) {
        const auto passes_on = [&](const BarrierDecl& b) {
            return b.src.layout == left && (kEveryStage & ~b.src.stages) == 0 &&
                   (kEveryWrite & ~b.src.access) == 0 && b.dst.layout == wanted.state.layout &&
                   (kEveryStage & ~b.dst.stages) == 0;
        };
        if (!covered_by(transition_.after, id, part, passes_on))
            add("C371", id, "keeps its memory, but the old frames may still use it",
                "record a barrier from all stages of the old plan to all stages of the new plan");
    }

    [[nodiscard]] AccessState writing_state(ResourceId id) const {
        const ResourceDecl& decl = new_.graph.resources[id];
        Access access = Access::clear_write;
        for (const ContentCopy& carry : transition_.carried)
            if (carry.to == id) access = carry.resample ? Access::blit_write : Access::copy_write;
        return access_state(access, 0, decl.kind == ResourceKind::image ? decl.aspects : aspect::kNone);
    }

    static const std::string& ring_name(const ResolvedGraph& graph, const ResourceDecl& decl) {
        return graph.resources[decl.ring].name;
    }
    // Returns the age of the content that the resource has between two frames, as a number of frames. A
    // resource with a single copy has the content of the last frame. This is also true for the copy of age 1
    // of a resource with history.
    static uint32_t frames_ago(const ResourceDecl& decl) { return decl.history == 0 ? 1 : decl.age; }

    // Returns true if the formats are equal, or if a blit converts one to the other.
    static bool formats_fit(const ResourceDecl& from, const ResourceDecl& to, const ContentCopy& carry) {
        const bool floats = format_info(from.format).numeric == NumericClass::float_like &&
                            format_info(to.format).numeric == NumericClass::float_like;
        return from.format == to.format || (carry.resample && floats && from.on_resize == OnResize::resample);
    }

    void check_carried(const ContentCopy& carry) {
        const ResourceDecl& decl = new_.graph.resources[carry.to];
        if (carry.from >= old_.graph.resources.size() || !old_.live.live_resources[carry.from]) {
            add("C370", carry.to, "gets its content from a resource that the old plan does not keep",
                "clear the resource, or copy the old resource of the same name");
            return;
        }
        if (carry.shared) return check_shared(carry);
        const ResourceDecl& from = old_.graph.resources[carry.from];
        if (from.lifetime != ResourceLifetime::persistent ||
            ring_name(old_.graph, from) != ring_name(new_.graph, decl) ||
            frames_ago(from) != frames_ago(decl) || !formats_fit(from, decl, carry))
            add("C370", carry.to, "gets its content from \"" + from.name + "\"",
                "copy only a resource of the same name, format and age; convert only floats");
        const bool same = from.extent == decl.extent && from.mips == decl.mips &&
                          from.layers == decl.layers && from.size_bytes == decl.size_bytes;
        if (!carry.resample && from.area != kNoId && decl.area == kNoId)
            add("C370", carry.to, "gets an image of which only the area has content",
                "scale the area to the whole image, or clear it");
        if (carry.resample ? decl.on_resize != OnResize::resample : !same)
            add("C370", carry.to, "has another size than the old resource that gives its content",
                "after a change of size, follow onResize");
        const AccessState reading =
            access_state(carry.resample ? Access::blit_read : Access::copy_read, 0,
                         from.kind == ResourceKind::image ? from.aspects : aspect::kNone);
        for (const BoundaryState& boundary : old_.boundary) {
            if (boundary.resource != carry.from) continue;
            const auto leaves = [&](const BarrierDecl& b) {
                return b.src.layout == boundary.state.layout && (kEveryStage & ~b.src.stages) == 0 &&
                       b.dst.layout == reading.layout && (reading.stages & ~b.dst.stages) == 0 &&
                       (reading.access & ~b.dst.access) == 0;
            };
            if (!covered_by(transition_.before_old, carry.from, boundary.range, leaves))
                add("C371", carry.to, "gets its content from a copy that the old frames may still use",
                    "record a barrier from all stages and layout " + layout_text(boundary.state.layout) +
                        " before the copy");
        }
    }

    const FramePlan& old_;
    const FramePlan& new_;
    const TransitionPlan& transition_;
    FaultList faults_;
};

}  // namespace

Diagnostics check_transition(const FramePlan& old_plan, const FramePlan& new_plan,
                             const TransitionPlan& transition) {
    return TransitionCheck(old_plan, new_plan, transition).run();
}

}  // namespace weft
