// Purpose: finds the mips, layers and aspects that a reference such as "hiz.mip(1..3)" selects, or the bytes
// that "args.range(0..2)" selects. Private to bind().
#pragma once

#include <optional>

#include "graph/resolve/bind.h"

namespace weft {

struct FoundRange {
    // The range in an image. For a buffer, divide_buffers() finds the range later, when all references are
    // known.
    SubresourceRange range;
    std::optional<ByteRange> bytes =
        {};  // The bytes of the elements that the reference names; absent if there are no such elements.
};
// Returns the range, or nullopt if an error in the reference was reported, now or earlier. Errors: W105.
[[nodiscard]] std::optional<FoundRange> find_range(PassId pass, const RefDesc& ref,
                                                   const ResourceDecl& resource, const Evaluator& evaluator,
                                                   Suspects& suspects, PassReporter& report);

}  // namespace weft
