// Purpose: the exit codes of the `weft` program. Scripts depend on these numbers, so they must not change.
// docs/command-line.md describes the codes for users.
#pragma once

namespace weft::viewer {

enum class ExitCode : int {
    ok = 0,
    failed = 1,         // Any failure that has no code of its own.
    usage = 2,          // The command line is wrong.
    invalid_input = 3,  // An input file is invalid or exceeds a limit.
    no_device = 4,      // The machine has no suitable Vulkan device.
    validation = 5,     // The validation layer reported a message.
    mismatch = 6,       // A picture or a test differs from its expectation.
    lost = 7,           // A frame exceeded the time-out, or the Vulkan device was lost.
};

}  // namespace weft::viewer
