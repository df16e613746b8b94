// Purpose: names combinations of switches in messages.
#pragma once

#include <string>
#include <vector>

#include "weft/switches.h"

namespace weft {

// Values of some of the switches. If bit s of `named` is 1, bit s of `values` is the value of switch s. If
// bit s of `named` is 0, the value of switch s is not given.
struct SwitchValues {
    uint32_t named = 0;
    Combination values = 0;

    // Returns the combinations in which the switches have these values.
    [[nodiscard]] CombinationSet combinations() const;
};

// Returns values of as few switches as possible, so that all combinations with these values are in the set.
// The set must not be empty.
[[nodiscard]] SwitchValues fewest_values(const std::vector<SwitchDecl>& switches, CombinationSet set);
// Returns a text such as `"fog" is off and "rain" is on`.
[[nodiscard]] std::string values_text(const std::vector<SwitchDecl>& switches, const SwitchValues& values);
// Returns the text for the result of fewest_values(), such as `"fog" is off and "rain" is on`.
[[nodiscard]] inline std::string switches_text(const std::vector<SwitchDecl>& switches, CombinationSet set) {
    return values_text(switches, fewest_values(switches, set));
}

}  // namespace weft
