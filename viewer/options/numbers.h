// Purpose: reads all numbers on the command line, so that none is NaN, infinite or out of range, and every
// message names the range and the unit. Errors: a text for the message; empty when the number is valid.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace weft::viewer {

// The range includes both ends.
struct NumberRange {
    double least = 0;
    double most = 0;
    const char* unit = "";  // such as "s" or "EV"; empty for counts
};

// A finite decimal number that uses the whole text; "nan" and "0x1p3" are invalid.
[[nodiscard]] std::optional<double> finite_number(std::string_view text);
// As finite_number(), or a fraction of two such numbers: "1/60".
[[nodiscard]] std::optional<double> finite_fraction(std::string_view text);
[[nodiscard]] std::optional<uint64_t> whole_number(std::string_view text);

[[nodiscard]] std::string number_fault(const std::string& text, const NumberRange& range);
[[nodiscard]] std::string fraction_fault(const std::string& text, const NumberRange& range);
[[nodiscard]] std::string whole_number_fault(const std::string& text, uint64_t least, uint64_t most);

// A decimal text that reads back as the same number.
[[nodiscard]] std::string decimal(double number);
// The range in the form used in help and messages: "0.001 to 3600 s".
[[nodiscard]] std::string describe(const NumberRange& range);

}  // namespace weft::viewer
