// Purpose: where the copies of resources with history are. A ring of N + 1 roles has N + 1 copies, and from
// frame to frame every role moves on to the next of them. Frames count from 0, since the executor was made.
// What another executor's frames wrote before them may count too.
#pragma once

#include <vector>

#include "weft/plan.h"
#include "weft/transition.h"

namespace weft::vk {

class Rings {
 public:
    Rings() = default;
    explicit Rings(const FramePlan& plan);

    // The role whose placement holds what `resource` names in this frame: itself unless it is one of a ring.
    [[nodiscard]] ResourceId copy(ResourceId resource, uint64_t frame) const;
    // The roles of the ring that `resource` belongs to, by age; only itself when it belongs to none.
    [[nodiscard]] std::vector<ResourceId> roles(ResourceId resource) const;
    // After how many frames the pass finds everything in the same places again.
    [[nodiscard]] uint64_t period(const PassDecl& pass) const;
    // Counts what `old` has written in its `frames` for the rings whose content comes from there.
    void carry_over(const Rings& old, uint64_t frames, const TransitionPlan& transition);
    // Whether a pass has written what `role` stands for by this frame.
    [[nodiscard]] bool valid(ResourceId role, uint64_t frame) const;

 private:
    struct Role {
        ResourceId ring = kNoId;
        uint32_t age = 0;
    };
    std::vector<Role> all_;                       // by ResourceId
    std::vector<std::vector<ResourceId>> roles_;  // by ring, then age
    std::vector<uint8_t> written_;                // by ring: a live pass writes it
    std::vector<uint64_t> carried_;               // by ring: frames written before frame 0
};

}  // namespace weft::vk
