// Purpose: formats sizes, fractions and counts for messages, such as "3.5 MiB" or "1.2 %".
#pragma once

#include <cstdint>
#include <string>

namespace weft {

// Formats a size: in bytes below 10 KiB, in KiB below 10 MiB, and otherwise in MiB. KiB and MiB have one
// decimal, as in "3.5 MiB".
[[nodiscard]] std::string bytes_text(uint64_t bytes);
// Formats a limit without decimals, such as "8 MiB", if the size is a whole number of GiB, MiB or KiB.
// Formats other sizes as bytes_text() does.
[[nodiscard]] std::string limit_bytes_text(uint64_t bytes);
// Formats the difference between two sizes with its sign: "+512 B", "-14.0 MiB", "+0 B".
[[nodiscard]] std::string bytes_change_text(uint64_t from_bytes, uint64_t to_bytes);
// Formats a number with at most 6 significant digits and without trailing zeros: "0.5", "16", "1e+06".
[[nodiscard]] std::string number_text(double value);
[[nodiscard]] std::string percent_text(uint64_t part, uint64_t whole);
// Formats a count with its noun, which gets an "s" unless the count is 1: "1 barrier", "2 barriers".
[[nodiscard]] std::string count_text(size_t count, const std::string& noun);

}  // namespace weft
