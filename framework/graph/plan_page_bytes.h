// Purpose: a scale of bytes on which small resources stay visible beside large ones: between any two places
// where one begins or ends there is some room, the rest is shared out by size. Units: pixels of the page.
#pragma once

#include <vector>

#include "weft/plan.h"

namespace weft {

struct ByteScale {
    std::vector<uint64_t> bytes;  // where something begins or ends, ascending, from 0
    std::vector<int32_t> y_px;    // of each
    bool exact = true;            // nothing is drawn larger than it is

    [[nodiscard]] int32_t height_px() const { return y_px.empty() ? 0 : y_px.back(); }
    // Of one of `bytes`.
    [[nodiscard]] int32_t at(uint64_t byte) const;
};

[[nodiscard]] ByteScale make_byte_scale(const MemoryPlan& memory, uint32_t heap);

}  // namespace weft
