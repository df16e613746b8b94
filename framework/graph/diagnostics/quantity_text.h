// Purpose: formats sizes and fractions for users: "3.5 MiB", "1.2 %".
#pragma once

#include <cstdint>
#include <string>

namespace weft {

// Bytes below 10 KiB, KiB below 10 MiB, otherwise MiB with one decimal.
[[nodiscard]] std::string bytes_text(uint64_t bytes);
// "8 MiB" for a power of two; other sizes as in bytes_text().
[[nodiscard]] std::string limit_bytes_text(uint64_t bytes);
// The difference of two sizes with its sign: "+512 B", "-14.0 MiB", "+0 B".
[[nodiscard]] std::string bytes_change_text(uint64_t from_bytes, uint64_t to_bytes);
// The shortest form of the value: "0.5", "16", "1e+06".
[[nodiscard]] std::string number_text(double value);
[[nodiscard]] std::string percent_text(uint64_t part, uint64_t whole);
// A count with its noun: "1 barrier", "2 barriers".
[[nodiscard]] std::string count_text(size_t count, const std::string& noun);

}  // namespace weft
