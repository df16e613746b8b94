// Purpose: reads files below one folder only. Absolute paths, URI schemes, and `..` or symbolic links that
// lead out of the folder are refused. Files that are not regular are refused too: reading a pipe would block,
// reading a device might never end. Errors: a `ReadFault` with a text; the caller adds the JSON value that
// requested the file.
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
    std::string message;  // the reason, when there is a fault
};

class RootedFolder {
 public:
    explicit RootedFolder(const std::filesystem::path& folder);

    // `uri` is a relative reference in the sense of RFC 3986, percent-encoded.
    [[nodiscard]] FileBytes read(std::string_view uri, uint64_t max_bytes) const;

 private:
    std::filesystem::path root_;  // canonical; empty when the folder does not exist
};

[[nodiscard]] FileBytes read_plain_file(const std::filesystem::path& file, uint64_t max_bytes);

// nullopt when an escape is malformed or encodes a NUL.
[[nodiscard]] std::optional<std::string> percent_decode(std::string_view uri);

// The bytes of a base64 `data:` URI; nullopt when it is malformed.
[[nodiscard]] bool is_data_uri(std::string_view uri);
[[nodiscard]] std::optional<std::vector<uint8_t>> decode_data_uri(std::string_view uri);

}  // namespace weft::scene
