// Purpose: files that a user may have meant by a path that leads nowhere.
#pragma once

#include "weft/result.h"

namespace weft::viewer {

// Adds "did you mean …?" to an error that says that a graph, picture or scene is missing (W002, X530, S101):
// files of its folder that are called alike, shipped graphs and built-in scenes. Other errors stay as they
// are.
void add_near_files(Diagnostic& error);

}  // namespace weft::viewer
