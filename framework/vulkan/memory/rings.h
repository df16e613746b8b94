// Purpose: finds the copies of resources with history. A history of N frames is a ring of N + 1 resources,
// one for each age from 0 (this frame) to N. The ring has N + 1 copies in memory. In each frame every age
// moves to the next copy. Frame 0 is the first frame after the creation of the executor. If the executor
// replaces another one, content that the other executor has written may be valid too.
#pragma once

#include <vector>

#include "weft/plan.h"
#include "weft/transition.h"

namespace weft::vk {

class Rings {
 public:
    Rings() = default;
    explicit Rings(const FramePlan& plan);

    // Returns the resource whose memory contains the content of `resource` in frame `frame`. This is
    // `resource` itself, unless it belongs to a ring of copies that rotate.
    [[nodiscard]] ResourceId copy(ResourceId resource, uint64_t frame) const;
    // Returns all resources of the ring that contains `resource`, ordered by age: this frame, one frame ago,
    // and so on. If `resource` belongs to no ring, returns only `resource`.
    [[nodiscard]] std::vector<ResourceId> roles(ResourceId resource) const;
    // Returns the number of frames after which `pass` uses the same copies of its resources again.
    [[nodiscard]] uint64_t period(const PassDecl& pass) const;
    // Called when this executor replaces another one. `old` are the rings of the other executor, which has
    // run `frames` frames. If `transition` keeps the content of a ring, its past frames become valid here.
    void inherit(const Rings& old, uint64_t frames, const TransitionPlan& transition);
    // True if a pass has written the content that resource `role` has in frame `frame`. `role` is one of the
    // ages of a ring, such as the content of two frames ago.
    [[nodiscard]] bool valid(ResourceId role, uint64_t frame) const;

 private:
    struct Role {
        ResourceId ring = kNoId;
        uint32_t age = 0;
    };
    // The ring to which each resource belongs (the copies of one resource with history), and its age in the
    // ring. Indexed by ResourceId.
    std::vector<Role> all_;
    // The resources of each ring: roles_[ring][age].
    std::vector<std::vector<ResourceId>> roles_;
    // For each ring (resource with history), 1 if a pass of the plan writes it.
    std::vector<uint8_t> written_;
    // For each ring (resource with history), the number of valid past frames that this executor took over
    // from the executor that it replaces.
    std::vector<uint64_t> inherited_;
};

}  // namespace weft::vk
