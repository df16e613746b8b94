// Purpose: parts of resources: mips, layers and aspects of an image, and bytes of a buffer. Units: bytes.
#pragma once

#include <compare>
#include <cstdint>

#include "weft/access.h"
#include "weft/format.h"

namespace weft {

// A part of a resource: `mips` mip levels from `mip` on, `layers` layers from `layer` on, and the given
// aspects. The layers of a buffer are its pieces (ResourceDecl::cuts_bytes); it has mip 0 and aspect kColor.
struct SubresourceRange {
    uint32_t mip = 0;
    uint32_t mips = 1;
    uint32_t layer = 0;
    uint32_t layers = 1;
    AspectMask aspects = aspect::kColor;
    bool operator==(const SubresourceRange&) const = default;
    auto operator<=>(const SubresourceRange&) const = default;
};
[[nodiscard]] bool overlaps(const SubresourceRange& a, const SubresourceRange& b);
[[nodiscard]] bool contains(const SubresourceRange& outer, const SubresourceRange& inner);

// A part of a buffer.
struct ByteRange {
    uint64_t offset_bytes = 0;
    uint64_t size_bytes = 0;
    [[nodiscard]] uint64_t end_bytes() const { return offset_bytes + size_bytes; }
    bool operator==(const ByteRange&) const = default;
};

}  // namespace weft
