// Purpose: the files that Weft ships (graphs, shaders, profiles), wherever the program was put, and reading
// plain files.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "weft/device_profile.h"
#include "weft/limits.h"
#include "weft/result.h"
#include "weft/source.h"

namespace weft::viewer {

// The folder that holds graphs/ and shaders/: ../share/weft beside the installed program, else found by
// walking up from the program itself.
[[nodiscard]] std::filesystem::path shipped_root();
// Where compiled shaders are kept between runs: $XDG_CACHE_HOME/weft or ~/.cache/weft; empty when neither is
// set.
[[nodiscard]] std::filesystem::path shader_cache();

// Reads one byte more than `most_bytes` at most, so that whoever limits a file sees when it is too large.
[[nodiscard]] std::optional<std::string> read_file(const std::string& path, uint64_t most_bytes);
[[nodiscard]] FileReader reader_up_to(uint64_t most_bytes);

// What a --limits file says; the defaults when `file` is empty. Errors: X560, W001 to W005.
[[nodiscard]] Result<Limits> load_limits(const std::string& file);

// A profile file, or one of the shipped profiles by its name ("tiler"); empty: lavapipe.
// Errors: W140, W141.
[[nodiscard]] Result<DeviceProfile> load_profile(const std::string& file_or_name);

}  // namespace weft::viewer
