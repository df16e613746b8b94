// Purpose: whether messages are coloured, and how a diagnostic looks then.
// Sources: no-color.org; bixense.com/clicolors; ECMA-48, "Select graphic rendition".
#pragma once

#include <string>

#include "weft/result.h"

namespace weft::viewer {

// Of a file descriptor: on a terminal, unless NO_COLOR is set or TERM is "dumb". FORCE_COLOR or
// CLICOLOR_FORCE, set to anything but 0, turns colours on in any case.
[[nodiscard]] bool wants_colors(int file_descriptor);

// As to_text(), with errors red, warnings yellow, codes bold, and what is underlined in the colour of its
// severity.
[[nodiscard]] std::string colored_text(const Diagnostic& diagnostic);

}  // namespace weft::viewer
