// Purpose: the exit codes of the `weft` program. Scripts depend on these numbers, so they must not change
// (docs/command-line.md).
#pragma once

namespace weft::viewer {

enum class ExitCode : int {
    ok = 0,
    failed = 1,
    usage = 2,
    invalid_input = 3,
    no_device = 4,
    validation = 5,
    mismatch = 6,
    lost = 7,
};

}  // namespace weft::viewer
