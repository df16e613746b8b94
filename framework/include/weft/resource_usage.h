// Purpose: the kinds of use for which a resource is created, as flags.
#pragma once

#include <cstdint>

#include "weft/access.h"

namespace weft {

using UsageMask = uint32_t;
namespace usage {
inline constexpr UsageMask kSampled = 1u << 0;
inline constexpr UsageMask kStorage = 1u << 1;
inline constexpr UsageMask kColorAttachment = 1u << 2;
inline constexpr UsageMask kDepthAttachment = 1u << 3;
inline constexpr UsageMask kTransferSrc = 1u << 4;
inline constexpr UsageMask kTransferDst = 1u << 5;
inline constexpr UsageMask kUniform = 1u << 6;
inline constexpr UsageMask kVertex = 1u << 7;
inline constexpr UsageMask kIndex = 1u << 8;
inline constexpr UsageMask kIndirect = 1u << 9;
}  // namespace usage

// Returns the usage flag that a resource needs for an access. Example: kSampled for Access::sampled_read.
[[nodiscard]] UsageMask usage_of(Access a);

}  // namespace weft
