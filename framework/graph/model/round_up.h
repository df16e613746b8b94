// Purpose: rounds sizes and offsets up to an alignment.
#pragma once

#include <cstdint>

namespace weft {

// Returns the smallest multiple of `multiple` that is not smaller than `bytes`.
[[nodiscard]] constexpr uint64_t round_up(uint64_t bytes, uint64_t multiple) {
    return (bytes + multiple - 1) / multiple * multiple;
}

}  // namespace weft
