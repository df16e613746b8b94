// Purpose: describes live switches: parameters that turn passes on and off from frame to frame, without a new
// plan. A combination says which switches are on in a frame. Everything that depends on switches stores the
// set of the combinations in which it applies.
#pragma once

#include <cstdint>
#include <string>

namespace weft {

inline constexpr uint32_t kMostSwitches = 4;  // The most switches of a graph.

// The switches that are on in a frame: bit s is 1 if switch s (ResolvedGraph::switches) is on. The bits of
// switches that the graph does not have mean nothing.
using Combination = uint32_t;
inline constexpr uint32_t kCombinationCount = 1u << kMostSwitches;
inline constexpr Combination kAllSwitchesOn = kCombinationCount - 1;

// A set of combinations: bit c is 1 if the set contains combination c.
using CombinationSet = uint16_t;
inline constexpr CombinationSet kEveryCombination = 0xFFFF;

[[nodiscard]] inline bool has_combination(CombinationSet set, Combination combination) {
    return (set >> (combination & kAllSwitchesOn) & 1u) != 0;
}

// Returns all combinations in which the switch is on.
[[nodiscard]] inline CombinationSet combinations_with(uint32_t switch_id) {
    CombinationSet set = 0;
    for (Combination c = 0; c < kCombinationCount; ++c)
        if ((c >> switch_id & 1u) != 0) set = static_cast<CombinationSet>(set | 1u << c);
    return set;
}

[[nodiscard]] inline CombinationSet complement(CombinationSet set) {
    return static_cast<CombinationSet>(~set & kEveryCombination);
}

// A switch of a graph. It is on if the value of the parameter is not 0.
struct SwitchDecl {
    std::string param;
};

}  // namespace weft
