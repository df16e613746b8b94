// Purpose: writes diagnostics as a SARIF log, which editors and code hosts can show beside the source lines.
// Lines and columns count from 1. Columns are in UTF-16 code units, as the log states. Source: "Static
// Analysis Results Interchange Format (SARIF) Version 2.1.0", OASIS Standard, 2020.
#pragma once

#include <string>

#include "weft/result.h"

namespace weft::viewer {

// Returns the text of the log. Explanations of the codes come from the installed docs/diagnostics.md; without
// that file, the log contains no explanations.
[[nodiscard]] std::string sarif_log(const Diagnostics& diagnostics);

}  // namespace weft::viewer
