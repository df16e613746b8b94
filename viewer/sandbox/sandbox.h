// Purpose: `--sandbox`: the rest of a command runs in a child process that can open only what its graph and
// scene may open and what the driver needs, has no network, and writes nothing but the files that the command
// line names. Linux only, with Landlock and seccomp; docs/SECURITY.md says what it keeps out.
// Errors: X595, this kernel has no sandbox: nothing runs then. X596, the child crashed.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "viewer/output/exit_code.h"

namespace weft::viewer {

struct SandboxNeeds {
    std::vector<std::string> read;      // files, and folders with all below them; empty ones are passed over
    std::vector<std::string> inputs;    // of these, the files that no output may replace
    std::vector<std::string*> outputs;  // files to write; empty: none
    bool device = false;                // Vulkan
};

// Starts the child. There it returns nothing, and the outputs are renamed: they lie in folders of their own,
// so that no other file beside them is in reach. Here it waits, moves what was written to where it belongs,
// and returns the exit code. Call it while there is one thread.
[[nodiscard]] std::optional<ExitCode> run_in_sandbox(const SandboxNeeds& needs);

}  // namespace weft::viewer
