// Purpose: runs the tests in a graph file on a device, with the validation layers. Error W161: an expectation
// is not met. Error W162: the validation layers print more messages than the test allows. Both errors name
// the line in the file. Devices and sessions add their own errors.
#pragma once

#include <string>

#include "viewer/commands/commands.h"

namespace weft::viewer {

// Runs all tests of the graph file. Prints one line per test to stderr. Returns the errors of the tests that
// failed.
[[nodiscard]] Diagnostics run_graph_tests(const std::string& file, const CheckOptions& options);

}  // namespace weft::viewer
