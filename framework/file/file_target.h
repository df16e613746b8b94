// Purpose: finds the target of a path that a user gave. Symbolic links are followed, and open descriptors of
// this process are recognised. Errors are values of errno.
#pragma once

#include <sys/stat.h>

#include <filesystem>
#include <optional>
#include <string>

namespace weft {

enum class TargetKind : uint8_t {
    file,        // A regular file, or a path at which no file exists yet.
    stream,      // A pipe, a device or a socket.
    descriptor,  // An open descriptor of this process, such as /dev/stdout or /dev/fd/N.
    folder,
};

struct FileTarget {
    TargetKind kind = TargetKind::file;
    std::filesystem::path path;  // The path after following the symbolic links at its end.
    // Number of the open descriptor for TargetKind::descriptor, else -1. FileTarget does not close it.
    int descriptor = -1;
    std::optional<struct stat> old;  // Status of the existing file; absent if no file exists.
    int error = 0;  // If it is not 0, the path cannot be resolved, and this is the value of errno.

    // Returns the folder of the file: "." for a name without a folder.
    [[nodiscard]] std::string folder() const {
        return path.has_parent_path() ? path.parent_path().string() : ".";
    }
};

[[nodiscard]] FileTarget find_target(const std::string& path);

}  // namespace weft
