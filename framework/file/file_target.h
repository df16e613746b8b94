// Purpose: resolves a path given by a user: follows links and recognises descriptors of this process. Errors
// are values of errno.
#pragma once

#include <sys/stat.h>

#include <filesystem>
#include <optional>
#include <string>

namespace weft {

enum class TargetKind : uint8_t {
    file,        // a regular file, or an unused name
    stream,      // a pipe, a device or a socket
    descriptor,  // an open descriptor of this process: /dev/stdout, /dev/fd/N
    folder,
};

struct FileTarget {
    TargetKind kind = TargetKind::file;
    std::filesystem::path path;      // the path after following links at its end
    int descriptor = -1;             // for TargetKind::descriptor; not owned
    std::optional<struct stat> old;  // status of the existing file
    int error = 0;                   // errno of the resolution; the path cannot be resolved

    // The folder of the file: "." for a name without a folder.
    [[nodiscard]] std::string folder() const {
        return path.has_parent_path() ? path.parent_path().string() : ".";
    }
};

[[nodiscard]] FileTarget find_target(const std::string& path);

}  // namespace weft
