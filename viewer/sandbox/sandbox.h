// Purpose: `--sandbox`: runs the rest of a command in a child process with restricted rights. It can open
// only the files of its graph and scene and those of the driver, has no network access, and writes only the
// files named on the command line. Linux only, with Landlock and seccomp; docs/SECURITY.md describes the
// protection. Errors: X595, this kernel has no sandbox: nothing runs. X596, the child crashed.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "viewer/output/exit_code.h"

namespace weft::viewer {

struct SandboxNeeds {
    std::vector<std::string> read;      // files, and folders with all files below them; empty entries are
                                        // ignored
    std::vector<std::string> inputs;    // of these, the files that no output may replace
    std::vector<std::string*> outputs;  // files to write; empty entries are ignored
    bool device = false;                // true if the command uses Vulkan
};

// Starts the child. In the child it returns nullopt, and the outputs have new names: each is in a separate
// folder, so that the child cannot reach other files beside it. The parent waits, moves the written files to
// their destinations, and returns the exit code. Call this while there is only one thread.
[[nodiscard]] std::optional<ExitCode> run_in_sandbox(const SandboxNeeds& needs);

}  // namespace weft::viewer
