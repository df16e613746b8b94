// Purpose: writes files and standard output without loss of data. A regular file is always complete: either
// the new one, or the old one if writing fails. For this, data is written to a draft in the same folder and,
// with Durability::on_disk, flushed to the disk. Then the draft replaces the old file in one step. If the
// file system supports it, the draft has no name, so that nothing remains of it even after SIGKILL.
// Permissions of an old file are kept. A symbolic link is followed: its target is replaced or created. Pipes,
// devices and descriptors (/dev/stdout, /dev/fd/N) are written directly, without a draft. Error X510: the
// file cannot be written. Error X512: standard output cannot be written.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "weft/result.h"

namespace weft {

enum class Durability : uint8_t {
    on_disk,  // The file survives a power failure.
    cached,   // A power failure may lose or damage the file. Use this for files that can be made again.
};

// Checks whether `path` can be written: its folder exists, permissions suffice, and it is not itself a
// folder. Call this before long work. A full disk is detected only when data is written.
[[nodiscard]] Status check_writable(const std::string& path);

// Writes a file. After an error, an old regular file at this path is unchanged.
[[nodiscard]] Status write_file(const std::string& path, std::string_view data,
                                Durability durability = Durability::on_disk);

// Writes to standard output. On network file systems and with disk quotas, some errors appear only when a
// descriptor is closed. write_stdout() reports these errors too.
[[nodiscard]] Status write_stdout(std::string_view data);

// Returns true for a pipe, a device or a descriptor. Data is written to these directly, without a draft.
[[nodiscard]] bool is_stream(const std::string& path);

}  // namespace weft
