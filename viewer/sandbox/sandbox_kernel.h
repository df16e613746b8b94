// Purpose: restricts the rights of this process with two features of the Linux kernel: Landlock for files,
// and seccomp for system calls. The restrictions are permanent and apply to all threads and child processes.
// Error X595: the kernel or the processor does not support the restrictions.
#pragma once

#include <filesystem>
#include <vector>

#include "weft/result.h"

namespace weft::viewer {

// Lists the files that the process may open. A folder includes all files below it. Missing files are ignored.
struct OpenRules {
    std::vector<std::filesystem::path> read;  // Files and folders that may be read.
    // Programs and folders of libraries that may be read and executed.
    std::vector<std::filesystem::path> run;
    std::vector<std::filesystem::path> write;  // Folders in which files may be created, written and removed.
    // Device files, or folders of device files, that may be read, written and controlled with ioctl.
    std::vector<std::filesystem::path> devices;
};

// Restricts this process to the given files and to the system calls that rendering needs. Only one thread may
// exist when the function is called.
[[nodiscard]] Status lock_this_process(const OpenRules& rules);

}  // namespace weft::viewer
