// Purpose: small binary files that are either whole or ignored. Layout, little-endian:
//   8 bytes magic "WEFTSHD1" | u64 payload length | u64 hash of the payload | payload
// Written beside their place and renamed into it, so a reader never meets half a file.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace weft::shader {

// The payload; nothing when the file is absent, cut short, damaged or larger than 64 MiB.
[[nodiscard]] std::optional<std::string> read_sealed(const std::filesystem::path& file);

// A cache that cannot be written is no error: the next run compiles again.
void write_sealed(const std::filesystem::path& file, std::string_view payload);

}  // namespace weft::shader
