// Purpose: what a frame delivers to the program: GPU times and the contents of resources that are read back.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "weft/declaration.h"

namespace weft::vk {

struct PassTiming {
    std::string pass;
    double gpu_ms = 0;  // negative: the device has no timestamps
};

struct FrameTiming {
    std::vector<PassTiming> passes;
    double record_ms = 0;
    double submit_ms = 0;
    double wait_ms = 0;  // for the frame slot's fence
};

// Tightly packed texels of one mip and layer after another, or a buffer's bytes.
struct ReadbackData {
    std::string pass;  // the readback pass
    uint64_t frame_index = 0;
    Format format = Format::undefined;
    Extent3D extent;
    std::vector<std::byte> bytes;
};

}  // namespace weft::vk
