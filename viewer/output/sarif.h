// Purpose: diagnostics as a SARIF log, which editors and code hosts show beside the lines they are about.
// Units: lines and columns count from 1; columns in UTF-16 code units, as the log says.
// Source: "Static Analysis Results Interchange Format (SARIF) Version 2.1.0", OASIS Standard, 2020.
#pragma once

#include <string>

#include "weft/result.h"

namespace weft::viewer {

// The log's text. What codes mean is taken from the shipped docs/diagnostics.md; without it the log says no
// more than the diagnostics do.
[[nodiscard]] std::string sarif_log(const Diagnostics& diagnostics);

}  // namespace weft::viewer
