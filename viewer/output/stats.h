// Purpose: what a run measured, as the JSON that `--stats` writes. Units are in the keys.
#pragma once

#include <string>
#include <vector>

#include "weft/vulkan/executor.h"

namespace weft::viewer {

struct StatsInput {
    vk::Device& device;
    const FramePlan& plan;
    const vk::ReadbackData& output;
    const std::vector<vk::FrameTiming>& timings;  // GPU times are null where there are none
    uint32_t frames = 0;
    std::string tier;                              // empty: the graph as it is
    uint64_t pipelines_built_on_frame_thread = 0;  // after the first frame could begin
};

[[nodiscard]] std::string stats_json(const StatsInput& input);

// Whether the resource behind a reference ("hdr@lighting.mip(0)") is stored × preExposure.
[[nodiscard]] bool is_pre_exposed(const FramePlan& plan, const std::string& reference);

// Whether it is a buffer, which is written as it is.
[[nodiscard]] bool is_buffer(const FramePlan& plan, const std::string& reference);

// Lower-case hex.
[[nodiscard]] std::string sha256(const std::vector<std::byte>& bytes);

}  // namespace weft::viewer
