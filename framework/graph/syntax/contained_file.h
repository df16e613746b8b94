// Purpose: files below a folder. Everything that opens files which other files name uses this: the includes
// of graphs and of shaders, the buffers and images of scenes. A link may lead to any place inside the folders
// and to none outside of them. Paths that are called real have no links in them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>

namespace weft {

enum class FileFault : uint8_t { none, missing, not_plain, too_large, unreadable };

// The folder's real path; empty where there is none.
[[nodiscard]] std::filesystem::path real_folder(const std::filesystem::path& folder);

// The path is absolute, or ".." leads above the folder where it begins.
[[nodiscard]] bool climbs_out(const std::filesystem::path& relative);

// Both are real paths. A folder does not lie below itself.
[[nodiscard]] bool lies_below(const std::filesystem::path& file, const std::filesystem::path& folder);

struct RealFile {
    std::filesystem::path path;  // real; empty: there is no such file
    bool is_inside = false;      // below one of the folders
};
// Follows the links of a path without opening anything. `folders` are real.
[[nodiscard]] RealFile find_real_file(const std::filesystem::path& path,
                                      std::span<const std::filesystem::path> folders);

// Whether the last part of a path may be a link. A path that was checked has none: one that is there now was
// put there since.
enum class LastLink : uint8_t { followed, refused };

struct PlainRead {
    uint64_t size_bytes = 0;  // read; or, where the file is too large, its size
    FileFault fault = FileFault::none;
};
// Reads a plain file into the memory that `room` gives for its size. Pipes and devices are not opened, so
// that nothing waits for them.
[[nodiscard]] PlainRead read_plain_file(const std::filesystem::path& path, uint64_t most_bytes, LastLink link,
                                        const std::function<std::span<std::byte>(uint64_t)>& room);

struct FileContent {
    std::string bytes;
    FileFault fault = FileFault::none;
};
[[nodiscard]] FileContent read_plain_file(const std::filesystem::path& path, uint64_t most_bytes,
                                          LastLink link);

}  // namespace weft
