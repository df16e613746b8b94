// Purpose: formats text of any length with printf's notation.
#pragma once

#include <string>

namespace weft::viewer {

[[gnu::format(printf, 1, 2)]] [[nodiscard]] std::string formatted(const char* format, ...);

}  // namespace weft::viewer
