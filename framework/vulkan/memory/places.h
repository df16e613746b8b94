// Purpose: places of copied data in one staging buffer.
#pragma once

#include <cstdint>

namespace weft::vk {

// The next place at or behind this offset. Units: bytes.
[[nodiscard]] inline uint64_t aligned_place(uint64_t offset_bytes) {
    constexpr uint64_t kAlignmentBytes = 16;
    return (offset_bytes + kAlignmentBytes - 1) / kAlignmentBytes * kAlignmentBytes;
}

}  // namespace weft::vk
