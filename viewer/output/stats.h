// Purpose: the measurements of a run as JSON. The option `--stats` writes this text. Keys such as "gpu_ms"
// and "heap_bytes" contain the unit.
#pragma once

#include <string>
#include <vector>

#include "weft/vulkan/executor.h"

namespace weft::viewer {

// One swap of a run, for --stats.
struct SwapRecord {
    std::string to;         // As given on the command line.
    uint32_t frame = 0;     // The first frame of the new graph, from 1.
    double prepare_ms = 0;  // Time of the second thread.
    double swap_ms = 0;     // Time for which the swap stops the frames. It includes `wait_ms`.
    double wait_ms = 0;     // Time until the second thread was ready; 0 if it was ready before.
    std::string rebuilt;    // Such as "12 of 140 pipelines, a new plan".
    bool failed = false;    // True if the graph has errors. Then the running graph stays.
};

struct StatsInput {
    vk::Device& device;
    const FramePlan& plan;
    const vk::ReadbackData& output;
    // CPU and GPU times of the frames. GPU times that the device cannot measure become null in the JSON.
    const std::vector<vk::FrameTiming>& timings;
    uint32_t frames = 0;
    std::string tier;  // Name of the tier; empty for the graph without a tier.
    // Number of pipelines that the thread that renders the frames has created since the session was created.
    // Each of these pipelines delayed a frame.
    uint64_t pipelines_built_on_frame_thread = 0;
    // Number of irradiance probes, and the times of the frames that lit them before the first frame.
    uint32_t probes = 0;
    const std::vector<vk::FrameTiming>& warm_up;
    const std::vector<SwapRecord>& swaps;  // Of --swap.
};

[[nodiscard]] std::string stats_json(const StatsInput& input);

// Returns true if the values of a resource are multiplied by the pre-exposure factor. `reference` is the
// reference to the resource, such as "hdr@lighting.mip(0)".
[[nodiscard]] bool is_pre_exposed(const FramePlan& plan, const std::string& reference);

// Returns true if the reference names a buffer. `weft render` writes the bytes of a buffer to the output file
// without conversion.
[[nodiscard]] bool is_buffer(const FramePlan& plan, const std::string& reference);

// Returns the SHA-256 hash of the bytes as lower-case hexadecimal text.
[[nodiscard]] std::string sha256(const std::vector<std::byte>& bytes);

}  // namespace weft::viewer
