// Purpose: prints diagnostics to stderr and chooses the exit code of the process for them.
#pragma once

#include "viewer/output/exit_code.h"
#include "weft/result.h"

namespace weft::viewer {

void report(const Diagnostics& diagnostics);
// Prints the error X571, which reports that memory ran out.
void report_out_of_memory();
// Returns the exit code that belongs to the diagnostic code of the first error:
//   lost: V407 and V408. no_device: all other V40x.
//   usage: X520 to X522.
//   mismatch: W161 and W189. validation: W162.
//   invalid_input: all other W codes, all S codes, X53x and X56x.
//   failed: all other codes.
[[nodiscard]] ExitCode exit_code_for(const Diagnostics& errors);

}  // namespace weft::viewer
