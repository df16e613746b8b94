// Purpose: reads the numbers of the command line. The functions `..._fault` reject NaN, infinity and values
// out of range. They return a message that names the range and its unit (if any), or an empty text if the
// number is valid.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace weft::viewer {

// Range of allowed numbers. Both ends are allowed.
struct NumberRange {
    double least = 0;
    double most = 0;
    const char* unit = "";  // Unit in messages, such as "s" or "EV"; empty if the numbers have no unit.
};

// Parses a finite decimal number. The whole text must be a number: "nan", "0x1p3" and "5 px" are invalid.
[[nodiscard]] std::optional<double> finite_number(std::string_view text);
// Parses a finite decimal number, or a fraction of two such numbers, such as "1/60".
[[nodiscard]] std::optional<double> finite_fraction(std::string_view text);
[[nodiscard]] std::optional<uint64_t> whole_number(std::string_view text);

[[nodiscard]] std::string number_fault(const std::string& text, const NumberRange& range);
[[nodiscard]] std::string fraction_fault(const std::string& text, const NumberRange& range);
[[nodiscard]] std::string whole_number_fault(const std::string& text, uint64_t least, uint64_t most);

// Returns a decimal text with so many digits that reading the text gives exactly the same number.
[[nodiscard]] std::string decimal(double number);
// Returns the range as text for help and messages, such as "0.001 to 3600 s".
[[nodiscard]] std::string describe(const NumberRange& range);

}  // namespace weft::viewer
