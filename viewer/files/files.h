// Purpose: finds the files that are part of Weft (graphs, shaders, profiles), wherever the program is
// installed. Also reads regular files up to a size limit.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "weft/device_profile.h"
#include "weft/file_reader.h"
#include "weft/limits.h"
#include "weft/result.h"

namespace weft::viewer {

// Returns the folder that contains graphs/ and shaders/. If the program is installed in bin/, this is
// bin/../share/weft. Otherwise, it is the nearest folder above the program that contains these two folders,
// or else the current folder.
[[nodiscard]] std::filesystem::path shipped_root();
// Returns the folder of the shader cache: $XDG_CACHE_HOME/weft/shaders or ~/.cache/weft/shaders. Returns an
// empty path if neither XDG_CACHE_HOME nor HOME is set.
[[nodiscard]] std::filesystem::path shader_cache();

// Returns the contents of a file, or nullopt if the file cannot be read. If the file is larger than
// `most_bytes`, the returned text has `most_bytes` + 1 bytes, so that the caller detects the excess.
[[nodiscard]] std::optional<std::string> read_file(const std::string& path, uint64_t most_bytes);
[[nodiscard]] FileReader reader_up_to(uint64_t most_bytes);

// Reads the file of the option --limits. Returns the default limits if `file` is empty. Errors: X560, W001 to
// W005.
[[nodiscard]] Result<Limits> load_limits(const std::string& file);

// Reads a device profile from a file, or one of the shipped profiles by its name, such as "tiler". An empty
// text selects the profile "lavapipe". Errors: W140, W141.
[[nodiscard]] Result<DeviceProfile> load_profile(const std::string& file_or_name);

}  // namespace weft::viewer
