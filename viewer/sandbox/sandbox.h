// Purpose: implements `--sandbox`: runs the rest of a command in a child process with restricted rights. The
// child can open only the files of its graph and scene and the files of the driver. It has no network access,
// and can write only the files that the command line names. The sandbox uses Landlock and seccomp, so it
// works only on Linux; docs/SECURITY.md describes the protection. Error X595: this kernel cannot provide the
// sandbox, so nothing runs. Error X596: the child crashed.
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
    std::vector<std::string> inputs;  // Files among those in `read` that no output file may replace.
    // Pointers to the paths of the files to write. Empty paths are ignored.
    std::vector<std::string*> outputs;
    // True if the command uses Vulkan, so that the child also needs the files of the driver.
    bool device = false;
};

// Starts the child process. In the child, the function returns nullopt, and the paths of the outputs have
// changed: each output is in a separate folder, so that the child cannot reach other files beside it. In the
// parent, the function waits for the child, moves the written files to the wanted paths, and returns the exit
// code. Only one thread may exist when it is called.
[[nodiscard]] std::optional<ExitCode> run_in_sandbox(const SandboxNeeds& needs);

}  // namespace weft::viewer
