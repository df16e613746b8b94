// Purpose: finds the copies of resources with history. A history of N frames is a ring of N + 1 resources,
// one for each age from 0 (this frame) to N. The ring has N + 1 copies in memory. In each frame every age
// moves to the next copy. Frame 0 is the first frame after the creation of the executor. Past content
// is valid if a frame has written it. Frames of an executor that was replaced may count too; see inherit().
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
    // run `frames` frames. If `transition` keeps the content of a ring, the past frames of this ring become
    // valid here.
    void inherit(const Rings& old, uint64_t frames, const TransitionPlan& transition);
    // True if a pass has written the content that resource `role` has in frame `frame`. `role` is the
    // resource of one age in a ring; for example, age 2 has the content of two frames ago.
    [[nodiscard]] bool valid(ResourceId role, uint64_t frame) const;

 private:
    struct Role {
        ResourceId ring = kNoId;
        uint32_t age = 0;
    };
    // By ResourceId: the ring of the resource, and the age of the resource in this ring. A ring is named by
    // the ResourceId of its age 0; kNoId: the resource belongs to no ring.
    std::vector<Role> all_;
    // The resources of each ring: roles_[ring][age].
    std::vector<std::vector<ResourceId>> roles_;
    // By ResourceId: 1 if a pass of the plan writes the resource, else 0.
    std::vector<uint8_t> written_;
    // By ring: the number of valid past frames that this executor took over from the executor that it
    // replaces.
    std::vector<uint64_t> inherited_;
};

}  // namespace weft::vk
