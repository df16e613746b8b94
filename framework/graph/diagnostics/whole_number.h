// Purpose: converts untrusted numbers to an integer or a float. In C++ a conversion is undefined behaviour if
// the value does not fit the target type, so all such conversions use these functions.
#pragma once

#include <cmath>
#include <limits>
#include <optional>

namespace weft {

// Returns true if `number` without its fraction fits into Int. Exception: returns false for -2^63, the
// smallest value of a signed 64-bit Int. Compares with `end`, which is the largest value of Int plus 1. This
// power of two is exact as a double, but the largest value itself (example: 2^63 - 1) may not be.
template <class Int>
[[nodiscard]] bool fits_into(double number) {
    static_assert(std::numeric_limits<Int>::is_integer);
    const double end = std::ldexp(1.0, std::numeric_limits<Int>::digits);
    return number > (std::numeric_limits<Int>::is_signed ? -end - 1 : -1) && number < end;
}

// Converts a number to Int. Returns nullopt for NaN, for numbers with a fraction, and for values outside the
// range of Int.
template <class Int>
[[nodiscard]] std::optional<Int> whole_number(double number) {
    if (number != std::floor(number) || !fits_into<Int>(number)) return std::nullopt;
    return static_cast<Int>(number);
}

// Removes the fraction of a number and clamps the number to the range of Int. Returns 0 for NaN.
template <class Int>
[[nodiscard]] Int saturated(double number) {
    if (std::isnan(number)) return 0;
    if (fits_into<Int>(number)) return static_cast<Int>(number);
    return number < 0 ? std::numeric_limits<Int>::min() : std::numeric_limits<Int>::max();
}

[[nodiscard]] inline bool fits_into_float(double number) {
    return std::abs(number) <= static_cast<double>(std::numeric_limits<float>::max());
}

// Converts a double to a float. Values beyond the range of float become the largest float with the same sign
// instead of infinity; NaN stays NaN.
[[nodiscard]] inline float saturated_float(double number) {
    if (std::isnan(number) || fits_into_float(number)) return static_cast<float>(number);
    return std::copysign(std::numeric_limits<float>::max(), number < 0 ? -1.0f : 1.0f);
}

}  // namespace weft
