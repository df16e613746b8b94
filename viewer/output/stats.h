// Purpose: the measurements of a run as JSON, as `--stats` writes them. The keys contain the units.
#pragma once

#include <string>
#include <vector>

#include "weft/vulkan/executor.h"

namespace weft::viewer {

struct StatsInput {
    vk::Device& device;
    const FramePlan& plan;
    const vk::ReadbackData& output;
    const std::vector<vk::FrameTiming>& timings;  // GPU times that are unavailable become null
    uint32_t frames = 0;
    std::string tier;                              // empty: the graph without a tier
    uint64_t pipelines_built_on_frame_thread = 0;  // counted after the first frame was ready to begin
};

[[nodiscard]] std::string stats_json(const StatsInput& input);

// True if the values of the resource in a reference ("hdr@lighting.mip(0)") are multiplied by preExposure.
[[nodiscard]] bool is_pre_exposed(const FramePlan& plan, const std::string& reference);

// True if the reference names a buffer, which is written without conversion.
[[nodiscard]] bool is_buffer(const FramePlan& plan, const std::string& reference);

// In lower-case hexadecimal.
[[nodiscard]] std::string sha256(const std::vector<std::byte>& bytes);

}  // namespace weft::viewer
