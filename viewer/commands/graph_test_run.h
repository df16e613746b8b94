// Purpose: runs the tests in a graph file on a device, with the validation layers. Errors: W161 an
// expectation that is not met, W162 more validation messages than the test allows, each with its place in the
// file; also the errors of devices and sessions.
#pragma once

#include <string>

#include "viewer/commands/commands.h"

namespace weft::viewer {

// Prints progress on stderr, one line per run.
[[nodiscard]] Diagnostics run_graph_tests(const std::string& file, const CheckOptions& options);

}  // namespace weft::viewer
