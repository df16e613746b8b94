// Purpose: names of the values of an enum, from a table in the order of the enum.
#pragma once

#include <array>
#include <cstddef>

namespace weft {

// Returns names[value], or "?" if the table has no such entry.
template <class E, size_t N>
[[nodiscard]] constexpr const char* name_of_value(E value, const std::array<const char*, N>& names) {
    const auto index = static_cast<size_t>(value);
    return index < N ? names[index] : "?";
}

}  // namespace weft
