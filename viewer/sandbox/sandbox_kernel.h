// Purpose: what the kernel offers to lock this process up in: Landlock for files, seccomp for system calls.
// No library beyond libc. Both hold for all threads and processes that this one starts, for good. Errors:
// X595, the kernel or the processor has no such thing, or refuses it.
#pragma once

#include <filesystem>
#include <vector>

#include "weft/result.h"

namespace weft::viewer {

// What may be opened. Folders stand for all that is below them. Files that are not there are passed over.
struct OpenRules {
    std::vector<std::filesystem::path> read;     // files and folders
    std::vector<std::filesystem::path> run;      // folders of libraries, and programs: read and executed
    std::vector<std::filesystem::path> write;    // folders in which files are made, written and removed
    std::vector<std::filesystem::path> devices;  // device files and folders of them: read, written, ioctl
};

// Call it while there is one thread.
[[nodiscard]] Status lock_this_process(const OpenRules& rules);

}  // namespace weft::viewer
