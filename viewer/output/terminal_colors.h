// Purpose: decides whether messages have colours, and formats diagnostics with colours. Sources:
// no-color.org, bixense.com/clicolors, and ECMA-48, "Select graphic rendition".
#pragma once

#include <string>

#include "weft/result.h"

namespace weft::viewer {

// Returns true if text for this file descriptor should have colours: on a terminal, unless NO_COLOR is set or
// TERM is "dumb". If FORCE_COLOR or CLICOLOR_FORCE is set to a value other than 0, the function always
// returns true. An empty variable counts as not set.
[[nodiscard]] bool wants_colors(int file_descriptor);

// Formats a diagnostic like to_text(), but with colours. For an error, the word "error" and the carets under
// the source line are red. For a warning, they are yellow. Codes and file positions are bold.
[[nodiscard]] std::string colored_text(const Diagnostic& diagnostic);

}  // namespace weft::viewer
