// Purpose: printf's notation for texts of any length.
#pragma once

#include <string>

namespace weft::viewer {

[[gnu::format(printf, 1, 2)]] [[nodiscard]] std::string formatted(const char* format, ...);

}  // namespace weft::viewer
