// Purpose: the transition from one plan to the next, for a resize, a reload or another quality tier. It tells
// which persistent resources keep their content, and which are initialised again. It runs once, on queue 0,
// after the last frame of the old plan; it replaces the prologue of the new plan. Units: ids in
// ContentCopy::from and in TransitionPlan::before_old are of the old plan, all other ids are of the new plan.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "weft/plan.h"

namespace weft {

// Copies the content of a resource of the old plan to the resource of the same name in the new plan. For a
// name such as "color[-1]", it is the content that the next frame of the old plan would read under this name.
struct ContentCopy {
    ResourceId from = kNoId;
    ResourceId to = kNoId;
    // True: the content is scaled to the new size mip by mip, with a linear filter (integers: nearest texel),
    // and converted to the new format. If the new resource has more mips, the additional mips are scaled from
    // the last old mip. False: the content is copied unchanged.
    bool resample = false;
    // True: both plans use the same memory, so nothing is copied.
    bool shared = false;
    bool operator==(const ContentCopy&) const = default;
};

struct TransitionPlan {
    // Barriers for resources of the old plan, from the states between its frames (BoundaryState).
    std::vector<BarrierDecl> before_old;
    std::vector<BarrierDecl> before;  // Barriers for resources of the new plan, from `undefined`.
    std::vector<ContentCopy> carried;
    std::vector<ResourceId> cleared;  // Resources to clear to ResourceDecl::first_frame.
    // Barriers for resources of the new plan, to the states that its first frame expects.
    std::vector<BarrierDecl> after;
    // Index: ResourceId of the new plan. For a resource with several copies (a ring), only the entry of the
    // copy of age 0 (the current frame) is used. The shader value `<port>Valid` (Builtin::valid) depends on
    // the number of frames that have written the resource. 1: frames of the old plan count, too. 0: the count
    // starts again.
    std::vector<uint8_t> keeps_validity;
};

// Returns true if a new plan can continue a resource of the old plan in the same memory: both declarations
// have
// `"keep": "shared"`, the same shape, the same format and the same usage.
[[nodiscard]] bool shares_memory(const ResourceDecl& old_decl, const ResourceDecl& decl);

[[nodiscard]] TransitionPlan transition(const FramePlan& old_plan, const FramePlan& new_plan);

// Returns a text about the content of a resource of the new plan: it is kept, copied, scaled, converted or
// lost. If it is lost, the text gives the reason. Example: `"glow" is converted from rgba16f to rgba32f`.
// `id` is the content of the current frame (age 0) or of the previous frame (age 1).
[[nodiscard]] std::string content_text(const FramePlan& old_plan, const FramePlan& new_plan,
                                       const TransitionPlan& transition, ResourceId id);

}  // namespace weft
