// Purpose: prints diagnostics to stderr and chooses the exit code of the process for them.
#pragma once

#include "viewer/output/exit_code.h"
#include "weft/result.h"

namespace weft::viewer {

void report(const Diagnostics& diagnostics);
// Prints the error X571, which reports that memory ran out.
void report_out_of_memory();
// Returns the exit code that belongs to the code of the first error. For example, V40x gives no_device, V407
// and V408 give lost, X520 to X522 give usage, and W, S, X53x and X56x give invalid_input.
[[nodiscard]] ExitCode exit_code_for(const Diagnostics& errors);

}  // namespace weft::viewer
