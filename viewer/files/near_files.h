// Purpose: suggests files with similar names for a path that does not exist.
#pragma once

#include "weft/result.h"

namespace weft::viewer {

// Adds "did you mean …?" to an error about a missing graph, picture or scene (W002, X530, S101): files of its
// folder with similar names, shipped graphs and built-in scenes. Other errors do not change.
void add_near_files(Diagnostic& error);

}  // namespace weft::viewer
