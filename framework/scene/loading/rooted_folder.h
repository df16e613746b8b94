// Purpose: reads files below one folder and nothing else. Absolute paths, schemes, `..` that climbs out, and
// symbolic links that lead out are refused; so is anything that is not a plain file (a pipe would block, a
// device never ends). Errors: as a `ReadFault` with a text; the caller knows which JSON value asked.
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
    std::string message;  // what was found, when there is a fault
};

class RootedFolder {
 public:
    explicit RootedFolder(const std::filesystem::path& folder);

    // `uri` is a relative reference as RFC 3986 has it, percent-encoded.
    [[nodiscard]] FileBytes read(std::string_view uri, uint64_t max_bytes) const;

 private:
    std::filesystem::path root_;  // canonical; empty when the folder does not exist
};

[[nodiscard]] FileBytes read_plain_file(const std::filesystem::path& file, uint64_t max_bytes);

// nullopt when an escape is malformed or hides a NUL.
[[nodiscard]] std::optional<std::string> percent_decode(std::string_view uri);

// The bytes of a `data:` URI, base64 only; nullopt when it is malformed.
[[nodiscard]] bool is_data_uri(std::string_view uri);
[[nodiscard]] std::optional<std::vector<uint8_t>> decode_data_uri(std::string_view uri);

}  // namespace weft::scene
