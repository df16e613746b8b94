// Purpose: the results of a frame that a program can read: GPU times, and the contents of resources that are
// read back.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "weft/declaration.h"

namespace weft::vk {

struct PassTiming {
    std::string pass;
    double gpu_ms = 0;  // Time on the GPU in ms; 0 if nothing was recorded; negative if it was not measured.
    // True if the pass did not run in this frame, because it has `rest` and its inputs have not changed, or
    // because other rounds of its group had their turn.
    bool rested = false;
    // True if the pass did not run in this frame, because its switch was off.
    bool switched_off = false;
    // Only for a pass that ran in this frame and that has `rest` or is in a group: the reason why it ran,
    // such as `pass "table" ran`. Empty for all other passes.
    std::string woken_by;
    // Number of draws that were not recorded because they are outside of the frustum of the view. With
    // several views: the sum of view_draws_left_out.
    uint32_t draws_left_out = 0;
    // The same number for each view of PassDecl::views, if the pass records its draws for each of them. Else
    // empty.
    std::vector<uint32_t> view_draws_left_out = {};
};

struct FrameTiming {
    std::vector<PassTiming> passes;
    double record_ms = 0;
    double submit_ms = 0;
    double wait_ms = 0;  // Time in milliseconds that the host waited for the fence of the frame slot.
    // Number of entries of FrameInput::turns that were ignored: rounds that do not exist, rounds that occur
    // twice, and rounds that come after the limit "perFrame" of their group is reached.
    uint32_t dropped_turns = 0;
};

// The content of a resource that was read back. For a buffer: its bytes. For an image: its texels without
// padding, ordered by mip, then by aspect, then by layer.
struct ReadbackData {
    std::string pass;  // Name of the readback pass.
    uint64_t frame_index = 0;
    Format format = Format::undefined;
    Extent3D extent;
    std::vector<std::byte> bytes;
};

}  // namespace weft::vk
