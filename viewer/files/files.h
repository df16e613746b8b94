// Purpose: finds the files that are part of Weft (graphs, shaders, profiles) wherever the program is
// installed, and reads regular files.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "weft/device_profile.h"
#include "weft/limits.h"
#include "weft/result.h"
#include "weft/source.h"

namespace weft::viewer {

// The folder that contains graphs/ and shaders/: ../share/weft beside the installed program, or else a folder
// above the program.
[[nodiscard]] std::filesystem::path shipped_root();
// The folder of the shader cache: $XDG_CACHE_HOME/weft or ~/.cache/weft; empty when neither variable is set.
[[nodiscard]] std::filesystem::path shader_cache();

// Reads at most `most_bytes` + 1 bytes, so that the caller can detect a file over the limit.
[[nodiscard]] std::optional<std::string> read_file(const std::string& path, uint64_t most_bytes);
[[nodiscard]] FileReader reader_up_to(uint64_t most_bytes);

// Reads a --limits file; returns the defaults when `file` is empty. Errors: X560, W001 to W005.
[[nodiscard]] Result<Limits> load_limits(const std::string& file);

// Reads a profile file, or one of the shipped profiles by its name ("tiler"); empty: lavapipe. Errors: W140,
// W141.
[[nodiscard]] Result<DeviceProfile> load_profile(const std::string& file_or_name);

}  // namespace weft::viewer
