// Purpose: compares the light of two pictures of half floats.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace weft::test {

// Returns the largest difference of two pictures with four non-negative values for each pixel. The unit is
// the step from one half float to the next. Alpha is not compared. Prints how many values differ after
// `name`.
[[nodiscard]] int most_half_steps(const std::string& name, std::span<const uint16_t> a,
                                  std::span<const uint16_t> b);

}  // namespace weft::test
