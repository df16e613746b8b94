// Purpose: reads and writes small binary files of the cache. A file that is not complete is ignored. Layout,
// little-endian:
//   8 bytes magic "WEFTSHD1" | u64 payload length | u64 hash of the payload | payload
// write_file() replaces a file in one step, so a reader does not see a file that is only partly written.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace weft::shader {

// Returns the payload of the file. Returns nullopt if the file does not exist, or is incomplete, damaged or
// larger than 64 MiB.
[[nodiscard]] std::optional<std::string> read_sealed(const std::filesystem::path& file);

// Writes the payload to the file. The function does not report errors: if the cache cannot be written, the
// next run compiles the shader again.
void write_sealed(const std::filesystem::path& file, std::string_view payload);

}  // namespace weft::shader
