// Purpose: the function with which Weft reads graph files. Tests and embedders can provide the texts.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace weft {

// A function that returns the text of a file, or nullopt if the file does not exist. All graph files are read
// with such a function, so that tests and embedders can provide texts.
using FileReader = std::function<std::optional<std::string>(const std::string& path)>;

// Returns a reader of files on disk. It reads only regular files. For a file with more than `most_bytes`
// bytes, it returns more than `most_bytes` zeros. The parser then reports that the file is too large.
[[nodiscard]] FileReader disk_reader(uint64_t most_bytes);

}  // namespace weft
