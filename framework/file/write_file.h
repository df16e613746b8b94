// Purpose: writes files and standard output without loss of data. A file is either complete or absent. Data
// is written to a draft in the same folder and flushed to the disk; then the draft replaces the old file in
// one step. The draft has no name if the file system supports this, so that nothing remains of it even after
// SIGKILL. Permissions of an old file are kept. Symbolic links are followed: the target of the link is
// replaced or created. Pipes, devices and descriptors (/dev/stdout, /dev/fd/N) are written directly. Errors:
// X510 the file cannot be written, X512 standard output cannot be written.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "weft/result.h"

namespace weft {

enum class Durability : uint8_t {
    on_disk,  // the file survives a power failure
    cached,   // for files that can be regenerated: a power failure may lose or damage them
};

// Checks before any work whether `path` can be written: its folder exists, permissions suffice, and it is not
// a folder itself. A full disk is detected only when data is written.
[[nodiscard]] Status check_writable(const std::string& path);

// After an error an existing old file is unchanged.
[[nodiscard]] Status write_file(const std::string& path, std::string_view data,
                                Durability durability = Durability::on_disk);

// Also reports errors that appear only when a descriptor is closed (network file systems, quotas).
[[nodiscard]] Status write_stdout(std::string_view data);

// True for a pipe, a device or a descriptor, to which data is written directly.
[[nodiscard]] bool is_stream(const std::string& path);

}  // namespace weft
