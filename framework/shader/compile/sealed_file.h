// Purpose: small binary files that are either complete or ignored. Layout, little-endian:
//   8 bytes magic "WEFTSHD1" | u64 payload length | u64 hash of the payload | payload
// A file is written under a temporary name and then renamed, so a reader never sees an incomplete file.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace weft::shader {

// The payload; nullopt when the file is absent, incomplete, damaged or larger than 64 MiB.
[[nodiscard]] std::optional<std::string> read_sealed(const std::filesystem::path& file);

// A cache that cannot be written is not an error: the next run compiles again.
void write_sealed(const std::filesystem::path& file, std::string_view payload);

}  // namespace weft::shader
