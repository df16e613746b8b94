// Purpose: writes files and standard output so that no data is lost.
// A file is complete or not there. The data goes to a draft in the same folder, reaches the disk, and then
// replaces the old file in one step; until then the old file stays. The draft has no name where the file
// system allows that, so that nothing is left of it even after SIGKILL. Permissions of an old file are kept.
// A symbolic link is followed: the file that it leads to is replaced or made. Pipes, devices and descriptors
// (/dev/stdout, /dev/fd/N) are written directly. Errors: X510 the file cannot be written, X512 standard
// output cannot be written.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "weft/result.h"

namespace weft {

enum class Durability : uint8_t {
    on_disk,  // the file survives a power failure
    cached,   // for files that can be made again: they may be lost or damaged by a power failure
};

// Says before any work is done whether `path` can be written: its folder exists, the rights are there, and it
// is not a folder itself. A full disk is noticed only when the data is written.
[[nodiscard]] Status check_writable(const std::string& path);

// On an error the old file, if there was one, is as it was.
[[nodiscard]] Status write_file(const std::string& path, std::string_view data,
                                Durability durability = Durability::on_disk);

// Errors that appear only when a descriptor is closed (network file systems, quotas) count as well.
[[nodiscard]] Status write_stdout(std::string_view data);

// True for a pipe, a device or a descriptor: data is written to it directly.
[[nodiscard]] bool is_stream(const std::string& path);

}  // namespace weft
