// Purpose: chooses the light probes that are lit anew in a frame. Such a probe "has a turn" in this frame. In
// a frame, at most kMostTurns irradiance probes or kMostReflectionTurns reflection probes have a turn. After
// a turn, a probe has no other turn for kLeastFramesBetween frames. Probes with fewer turns come first, and
// among these the ones nearest to the camera. So each of n irradiance probes has a turn at least every 2
// ⌈n/4⌉ frames, if there are enough probes for four turns in each frame (more than 40). Pure data. Units:
// metres.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace weft::render {

class ProbeTurns {
 public:
    static constexpr uint32_t kMostTurns = 4;
    // Only 1 per frame, because a reflection probe has 16 times as many texels as an irradiance probe.
    static constexpr uint32_t kMostReflectionTurns = 1;
    static constexpr uint64_t kLeastFramesBetween = 10;

    ProbeTurns() = default;
    explicit ProbeTurns(std::vector<glm::vec3> places, uint32_t most_turns = kMostTurns);

    [[nodiscard]] size_t size() const { return probes_.size(); }
    // Begins the next frame, and returns the numbers of the probes that have a turn in it.
    [[nodiscard]] std::vector<uint32_t> next(const glm::vec3& camera);

 private:
    struct Place {
        glm::vec3 position{0};
        uint64_t turns = 0;
        uint64_t may_run_from = 0;  // The frame from which on the probe may have its next turn.
    };
    std::vector<Place> probes_;
    uint32_t most_turns_ = kMostTurns;
    uint64_t frame_ = 0;
};

}  // namespace weft::render
