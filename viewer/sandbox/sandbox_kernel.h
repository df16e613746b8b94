// Purpose: restricts this process with the kernel's means: Landlock for files, seccomp for system calls,
// without a library beyond libc. The restrictions are permanent and apply to all threads and child processes.
// Errors: X595, the kernel or the processor does not support them, or refuses them.
#pragma once

#include <filesystem>
#include <vector>

#include "weft/result.h"

namespace weft::viewer {

// The files that may be opened. A folder includes all files below it. Missing files are ignored.
struct OpenRules {
    std::vector<std::filesystem::path> read;     // files and folders
    std::vector<std::filesystem::path> run;      // folders of libraries, and programs: may be read and
                                                 // executed
    std::vector<std::filesystem::path> write;    // folders in which files may be created, written and removed
    std::vector<std::filesystem::path> devices;  // device files and folders of them: read, write, ioctl
};

// Call this while there is only one thread.
[[nodiscard]] Status lock_this_process(const OpenRules& rules);

}  // namespace weft::viewer
