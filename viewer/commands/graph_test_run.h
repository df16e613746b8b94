// Purpose: runs the tests that a graph file holds, on a device, under the validation layers.
// Errors: W161 an expectation that isn't met, W162 more validation messages than it allows, each at its place
// in the file; and those of devices and sessions.
#pragma once

#include <string>

#include "viewer/commands/commands.h"

namespace weft::viewer {

// Progress goes to stderr, one line for each run.
[[nodiscard]] Diagnostics run_graph_tests(const std::string& file, const CheckOptions& options);

}  // namespace weft::viewer
