// Purpose: numbers on the command line. Every one of them is read here, so that none is NaN, infinite or out
// of range, and every message names the range and the unit. Errors: a text for the message; empty when the
// number is good.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace weft::viewer {

// Both ends are allowed.
struct NumberRange {
    double least = 0;
    double most = 0;
    const char* unit = "";  // "s", "EV"; empty for counts
};

// Finite and decimal, all of the text; no "nan", no "0x1p3".
[[nodiscard]] std::optional<double> finite_number(std::string_view text);
// The same, or a fraction of two such numbers: "1/60".
[[nodiscard]] std::optional<double> finite_fraction(std::string_view text);
[[nodiscard]] std::optional<uint64_t> whole_number(std::string_view text);

[[nodiscard]] std::string number_fault(const std::string& text, const NumberRange& range);
[[nodiscard]] std::string fraction_fault(const std::string& text, const NumberRange& range);
[[nodiscard]] std::string whole_number_fault(const std::string& text, uint64_t least, uint64_t most);

// Reads back as the same number.
[[nodiscard]] std::string decimal(double number);
// As the range stands in help and messages: "0.001 to 3600 s".
[[nodiscard]] std::string describe(const NumberRange& range);

}  // namespace weft::viewer
