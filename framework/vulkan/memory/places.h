// Purpose: aligns the pieces of data in a staging buffer.
#pragma once

#include <cstdint>

namespace weft::vk {

// Returns the first multiple of 16 bytes that is not smaller than `offset_bytes`. The next piece of data
// starts there. Copies between images and buffers need offsets that are multiples of the texel size; the
// largest texels have 16 bytes.
[[nodiscard]] inline uint64_t aligned_place(uint64_t offset_bytes) {
    constexpr uint64_t kAlignmentBytes = 16;
    return (offset_bytes + kAlignmentBytes - 1) / kAlignmentBytes * kAlignmentBytes;
}

}  // namespace weft::vk
