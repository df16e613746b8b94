// Purpose: decides whether messages have colours, and formats diagnostics with colours. Sources:
// no-color.org; bixense.com/clicolors; ECMA-48, "Select graphic rendition".
#pragma once

#include <string>

#include "weft/result.h"

namespace weft::viewer {

// For a file descriptor: true on a terminal, unless NO_COLOR is set or TERM is "dumb". FORCE_COLOR or
// CLICOLOR_FORCE, with any value but 0, always enables colours.
[[nodiscard]] bool wants_colors(int file_descriptor);

// As to_text(), with errors red, warnings yellow, codes bold, and underlines in the colour of the severity.
[[nodiscard]] std::string colored_text(const Diagnostic& diagnostic);

}  // namespace weft::viewer
