// Purpose: sizes and shares as people read them: "3.5 MiB", "1.2 %".
#pragma once

#include <cstdint>
#include <string>

namespace weft {

// Whole bytes below 10 KiB, then KiB below 10 MiB, then MiB, with one decimal.
[[nodiscard]] std::string bytes_text(uint64_t bytes);
// "8 MiB" of a power of two; as bytes_text() of others.
[[nodiscard]] std::string limit_bytes_text(uint64_t bytes);
// The way from one size to another, with its sign: "+512 B", "-14.0 MiB"; "+0 B" where there is none.
[[nodiscard]] std::string bytes_change_text(uint64_t from_bytes, uint64_t to_bytes);
// As short as its value allows: "0.5", "16", "1e+06".
[[nodiscard]] std::string number_text(double value);
[[nodiscard]] std::string percent_text(uint64_t part, uint64_t whole);
// "1 barrier", "2 barriers".
[[nodiscard]] std::string count_text(size_t count, const std::string& noun);

}  // namespace weft
