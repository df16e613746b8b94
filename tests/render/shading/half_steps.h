// Purpose: compares the light of deferred shading with that of forward shading that rounds as the G-buffer
// does.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace weft::test {

// Reads a file. In forward.json, it sets the constant `quantized` to 1: the graph then rounds material values
// as the G-buffer does.
[[nodiscard]] std::optional<std::string> read_quantized(const std::string& path);

// Returns the largest difference of two pictures with four non-negative values for each pixel. The unit is
// the step from one half float to the next. Alpha is not compared. Prints how many values differ after
// `name`.
[[nodiscard]] int most_half_steps(const std::string& name, std::span<const uint16_t> a,
                                  std::span<const uint16_t> b);

}  // namespace weft::test
