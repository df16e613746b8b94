// Purpose: if a file does not exist, suggests files with similar names.
#pragma once

#include "weft/result.h"

namespace weft::viewer {

// Adds "did you mean ...?" to an error about a missing graph, picture or scene (W002, X530, S101). The
// suggestions are files with similar names in the same folder, shipped graphs and built-in scenes. Other
// errors do not change.
void add_near_files(Diagnostic& error);

}  // namespace weft::viewer
