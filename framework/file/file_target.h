// Purpose: where a path given by a user leads: links are followed, and descriptors of this process are
// recognised. Errors are values of errno.
#pragma once

#include <sys/stat.h>

#include <filesystem>
#include <optional>
#include <string>

namespace weft {

enum class TargetKind : uint8_t {
    file,        // a plain file, or a name that is free
    stream,      // a pipe, a device or a socket
    descriptor,  // an open descriptor of this process: /dev/stdout, /dev/fd/N
    folder,
};

struct FileTarget {
    TargetKind kind = TargetKind::file;
    std::filesystem::path path;      // after the links at its end
    int descriptor = -1;             // of TargetKind::descriptor; not owned
    std::optional<struct stat> old;  // what is there now
    int error = 0;                   // errno of the search: it leads nowhere

    // The folder that holds the file: "." for a bare name.
    [[nodiscard]] std::string folder() const {
        return path.has_parent_path() ? path.parent_path().string() : ".";
    }
};

[[nodiscard]] FileTarget find_target(const std::string& path);

}  // namespace weft
