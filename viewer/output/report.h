// Purpose: prints diagnostics to stderr, and gives the exit code that they stand for.
#pragma once

#include "viewer/output/exit_code.h"
#include "weft/result.h"

namespace weft::viewer {

void report(const Diagnostics& diagnostics);
// X571, for an exception that came from an allocation.
void report_out_of_memory();
// The exit code that the first error's code stands for: W, S, X53x, X56x: input; V40x: device; V407, V408:
// lost; X520 to X522: usage.
[[nodiscard]] ExitCode exit_code_for(const Diagnostics& errors);

}  // namespace weft::viewer
