// Purpose: writes diagnostics as a SARIF log, which editors and code hosts can display beside the source
// lines. Units: lines and columns count from 1; columns in UTF-16 code units, as the log states. Source:
// "Static Analysis Results Interchange Format (SARIF) Version 2.1.0", OASIS Standard, 2020.
#pragma once

#include <string>

#include "weft/result.h"

namespace weft::viewer {

// The text of the log. Explanations of codes come from the installed docs/diagnostics.md; without this file
// the log contains only the diagnostics.
[[nodiscard]] std::string sarif_log(const Diagnostics& diagnostics);

}  // namespace weft::viewer
