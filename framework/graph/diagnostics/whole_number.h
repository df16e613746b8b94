// Purpose: converts untrusted numbers to an integer or a float. In C++ a conversion that does not fit is
// undefined behaviour, so all such conversions use these functions.
#pragma once

#include <cmath>
#include <limits>
#include <optional>

namespace weft {

// True for a number in Int's range after dropping the fraction. The bounds are powers of two, so they are
// exact as doubles.
template <class Int>
[[nodiscard]] bool fits_into(double number) {
    static_assert(std::numeric_limits<Int>::is_integer);
    const double end = std::ldexp(1.0, std::numeric_limits<Int>::digits);
    return number > (std::numeric_limits<Int>::is_signed ? -end - 1 : -1) && number < end;
}

// nullopt for fractions, values outside Int's range, and NaN.
template <class Int>
[[nodiscard]] std::optional<Int> whole_number(double number) {
    if (number != std::floor(number) || !fits_into<Int>(number)) return std::nullopt;
    return static_cast<Int>(number);
}

// The nearest value in Int's range, without its fraction; 0 for NaN.
template <class Int>
[[nodiscard]] Int saturated(double number) {
    if (std::isnan(number)) return 0;
    if (fits_into<Int>(number)) return static_cast<Int>(number);
    return number < 0 ? std::numeric_limits<Int>::min() : std::numeric_limits<Int>::max();
}

[[nodiscard]] inline bool fits_into_float(double number) {
    return std::abs(number) <= static_cast<double>(std::numeric_limits<float>::max());
}

// Values that are too large become the largest float instead of infinity; NaN stays NaN.
[[nodiscard]] inline float saturated_float(double number) {
    if (std::isnan(number) || fits_into_float(number)) return static_cast<float>(number);
    return std::copysign(std::numeric_limits<float>::max(), number < 0 ? -1.0f : 1.0f);
}

}  // namespace weft
