// Purpose: reads files below one folder only. Absolute paths and URI schemes are refused, and so are `..` and
// symbolic links that lead out of the folder. Files that are not regular are refused too: reading a pipe
// would block, and reading a device might never end. Errors: a `ReadFault` with a text. The caller adds the
// place of the JSON value that names the file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace weft::scene {

enum class ReadFault : uint8_t { escapes, missing, unreadable, too_large };

struct FileBytes {
    std::vector<uint8_t> bytes;
    std::optional<ReadFault> fault;
    std::string message;  // Text that explains the fault; empty when the file was read.
};

class RootedFolder {
 public:
    explicit RootedFolder(const std::filesystem::path& folder);

    // Reads the file that `uri` names. `uri` is a relative reference in the sense of RFC 3986,
    // percent-encoded.
    [[nodiscard]] FileBytes read(std::string_view uri, uint64_t max_bytes) const;

 private:
    std::filesystem::path root_;  // Canonical path of the folder; empty when the folder does not exist.
};

// Reads a regular file of at most `max_bytes` bytes at any path: the rules of RootedFolder do not apply.
[[nodiscard]] FileBytes read_plain_file(const std::filesystem::path& file, uint64_t max_bytes);

// Decodes percent escapes ("%20" is a space). Returns nullopt when an escape is malformed or encodes a NUL
// byte.
[[nodiscard]] std::optional<std::string> percent_decode(std::string_view uri);

// is_data_uri() says whether `uri` is a `data:` URI. decode_data_uri() returns the bytes of a base64 `data:`
// URI, or nullopt when the URI is malformed.
[[nodiscard]] bool is_data_uri(std::string_view uri);
[[nodiscard]] std::optional<std::vector<uint8_t>> decode_data_uri(std::string_view uri);

}  // namespace weft::scene
