// Purpose: implements `--sandbox`, which runs the rest of a command in a child process with restricted
// rights. The child can read only the files that its command needs, such as those of the graph, the scene,
// the libraries and the driver. It has no network access, and can write only the output files of the command.
// The sandbox uses Landlock and seccomp, so it works only on Linux; docs/SECURITY.md describes the
// protection. Error X595: the sandbox is not available, so nothing runs. Error X596: a signal ended the
// child.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "viewer/output/exit_code.h"

namespace weft::viewer {

struct SandboxNeeds {
    // Files and folders that the child may read; a folder includes all files below it. Empty entries are
    // ignored.
    std::vector<std::string> read;
    std::vector<std::string> inputs;  // Input files that no output may replace.
    // Pointers to the paths of the files to write. Empty paths are ignored.
    std::vector<std::string*> outputs;
    // True if the command uses Vulkan, so that the child also needs the files of the driver.
    bool device = false;
};

// Starts the child process. In the child, the function returns nullopt, and the paths of output files have
// changed: each file is in its own temporary folder, so that the child cannot change other files in the
// wanted folder. In the parent, the function waits for the child, moves the written files to the wanted
// paths, and returns the exit code. Only one thread may exist when the function is called.
[[nodiscard]] std::optional<ExitCode> run_in_sandbox(const SandboxNeeds& needs);

}  // namespace weft::viewer
