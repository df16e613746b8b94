// Purpose: finds and reads files below a folder. All code that opens a file named in another file uses these
// functions: for includes of graphs and shaders, and for buffers and images of scenes. Symbolic links may
// lead to any place inside the allowed folders, but not out of them. A "real path" is a path in which all
// symbolic links are resolved.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>

namespace weft {

enum class FileFault : uint8_t { none, missing, not_plain, too_large, unreadable };

// Returns the path of the folder with all symbolic links resolved, or an empty path if the folder does not
// exist.
[[nodiscard]] std::filesystem::path real_folder(const std::filesystem::path& folder);

// Returns true if the path is absolute, or if its ".." parts lead above the folder where it starts.
[[nodiscard]] bool climbs_out(const std::filesystem::path& relative);

// Returns true if the file is somewhere below the folder. Both paths must have no symbolic links. A folder is
// not below itself.
[[nodiscard]] bool lies_below(const std::filesystem::path& file, const std::filesystem::path& folder);

struct RealFile {
    // The path with all symbolic links resolved; empty if no such file exists.
    std::filesystem::path path;
    // True if the file lies below one of the allowed folders.
    bool is_inside = false;
};
// Resolves the symbolic links of a path without opening the file. The paths in `folders` must have no
// symbolic links.
[[nodiscard]] RealFile find_real_file(const std::filesystem::path& path,
                                      std::span<const std::filesystem::path> folders);

// Says whether the last part of a path may be a symbolic link. Callers pass `refused` for a path whose links
// were already resolved: a link found there was created afterwards, perhaps to lead out of the folder.
enum class LastLink : uint8_t { followed, refused };

struct PlainRead {
    // Number of bytes read. If the file is too large to be read, the size of the file.
    uint64_t size_bytes = 0;
    FileFault fault = FileFault::none;
};
// Reads a regular file of at most `most_bytes` bytes. Calls `room` with the size of the file in bytes and
// reads into the memory that `room` returns. Does not open pipes and devices, because opening them may block.
[[nodiscard]] PlainRead read_plain_file(const std::filesystem::path& path, uint64_t most_bytes, LastLink link,
                                        const std::function<std::span<std::byte>(uint64_t)>& room);

struct FileContent {
    std::string bytes;
    FileFault fault = FileFault::none;
};
[[nodiscard]] FileContent read_plain_file(const std::filesystem::path& path, uint64_t most_bytes,
                                          LastLink link);

}  // namespace weft
