// Purpose: the time of each group of a graph in each frame: the sum of the times of the passes of the group.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "weft/plan.h"
#include "weft/vulkan/frame_results.h"

namespace weft::viewer {

struct GroupTimes {
    std::string name;
    uint32_t rounds = 0;  // Number of rounds of the group.
    // For each frame: the number of rounds that ran, and their time in milliseconds. The time is negative if
    // it was not measured.
    std::vector<uint32_t> ran;
    std::vector<double> gpu_ms;
    // The time of each pass of the group in all rounds that ran, by the name of the pass without the number
    // of the round, such as "bake::faces". Negative if it was not measured.
    std::map<std::string, double> pass_ms;

    [[nodiscard]] uint64_t all_ran() const;
    // Returns the time of all frames; negative if the time of a frame was not measured.
    [[nodiscard]] double all_gpu_ms() const;
};

// Returns the name of a pass without the number of its round, such as "bake::faces" for "bake::faces#3".
[[nodiscard]] std::string name_without_round(const std::string& pass);

// Returns the times of all groups of the plan. `timings` are the times of frames that ran with this plan.
[[nodiscard]] std::vector<GroupTimes> group_times(const FramePlan& plan,
                                                  std::span<const vk::FrameTiming> timings);

}  // namespace weft::viewer
