// Purpose: prints diagnostics on stderr and returns the matching exit code.
#pragma once

#include "viewer/output/exit_code.h"
#include "weft/result.h"

namespace weft::viewer {

void report(const Diagnostics& diagnostics);
// X571, for a failed allocation.
void report_out_of_memory();
// The exit code for the first error, by its code: W, S, X53x, X56x: input; V40x: device; V407, V408: lost;
// X520 to X522: usage.
[[nodiscard]] ExitCode exit_code_for(const Diagnostics& errors);

}  // namespace weft::viewer
