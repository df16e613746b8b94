// Purpose: formats text in the notation of printf and returns it as a string of any length.
#pragma once

#include <string>

namespace weft::viewer {

[[gnu::format(printf, 1, 2)]] [[nodiscard]] std::string formatted(const char* format, ...);

}  // namespace weft::viewer
