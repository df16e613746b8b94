// Purpose: finds and reads files below a folder. All code that opens files named in other files uses this:
// includes of graphs and shaders, buffers and images of scenes. A symbolic link may lead to any place inside
// the folders, but not out of them. Paths called real contain no links.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>

namespace weft {

enum class FileFault : uint8_t { none, missing, not_plain, too_large, unreadable };

// The folder's real path; empty if the folder does not exist.
[[nodiscard]] std::filesystem::path real_folder(const std::filesystem::path& folder);

// True if the path is absolute, or if ".." leads above its starting folder.
[[nodiscard]] bool climbs_out(const std::filesystem::path& relative);

// Both are real paths. A folder is not below itself.
[[nodiscard]] bool lies_below(const std::filesystem::path& file, const std::filesystem::path& folder);

struct RealFile {
    std::filesystem::path path;  // real path; empty: no such file exists
    bool is_inside = false;      // below one of the folders
};
// Resolves the links of a path without opening a file. `folders` are real paths.
[[nodiscard]] RealFile find_real_file(const std::filesystem::path& path,
                                      std::span<const std::filesystem::path> folders);

// Whether the last part of a path may be a link. A path that was already resolved has none; a link there now
// was created afterwards.
enum class LastLink : uint8_t { followed, refused };

struct PlainRead {
    uint64_t size_bytes = 0;  // number of bytes read; if the file is too large, its size
    FileFault fault = FileFault::none;
};
// Reads a regular file into the memory that `room` returns for its size. Pipes and devices are not opened,
// because they may block.
[[nodiscard]] PlainRead read_plain_file(const std::filesystem::path& path, uint64_t most_bytes, LastLink link,
                                        const std::function<std::span<std::byte>(uint64_t)>& room);

struct FileContent {
    std::string bytes;
    FileFault fault = FileFault::none;
};
[[nodiscard]] FileContent read_plain_file(const std::filesystem::path& path, uint64_t most_bytes,
                                          LastLink link);

}  // namespace weft
