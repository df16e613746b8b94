// Purpose: finds the copies of resources with history. A ring of N + 1 resources (ages 0 to N) has N + 1
// copies; in each frame every age moves to the next copy. Frames count from 0, from the creation of the
// executor. Content written by a previous executor may be valid too.
#pragma once

#include <vector>

#include "weft/plan.h"
#include "weft/transition.h"

namespace weft::vk {

class Rings {
 public:
    Rings() = default;
    explicit Rings(const FramePlan& plan);

    // The resource whose placement holds the content of `resource` in this frame: itself, unless it belongs
    // to a ring.
    [[nodiscard]] ResourceId copy(ResourceId resource, uint64_t frame) const;
    // The resources of the ring of `resource`, ordered by age; only itself if it belongs to none.
    [[nodiscard]] std::vector<ResourceId> roles(ResourceId resource) const;
    // The number of frames after which the pass uses the same copies again.
    [[nodiscard]] uint64_t period(const PassDecl& pass) const;
    // Adds the frames that `old` has written, for rings whose content the transition keeps.
    void inherit(const Rings& old, uint64_t frames, const TransitionPlan& transition);
    // True if a pass has written the content of `role` by this frame.
    [[nodiscard]] bool valid(ResourceId role, uint64_t frame) const;

 private:
    struct Role {
        ResourceId ring = kNoId;
        uint32_t age = 0;
    };
    std::vector<Role> all_;                       // index: ResourceId
    std::vector<std::vector<ResourceId>> roles_;  // indexed by ring, then age
    std::vector<uint8_t> written_;                // index: ring; 1 if a live pass writes it
    std::vector<uint64_t> inherited_;             // index: ring; number of frames written before frame 0
};

}  // namespace weft::vk
