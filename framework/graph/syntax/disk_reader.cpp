#include "graph/syntax/contained_file.h"
#include "weft/file_reader.h"

namespace weft {

FileReader disk_reader(uint64_t most_bytes) {
    return [most_bytes](const std::string& path) -> std::optional<std::string> {
        FileContent content = read_plain_file(path, most_bytes, LastLink::followed);
        if (content.fault == FileFault::too_large) return std::string(most_bytes + 1, '\0');
        if (content.fault != FileFault::none) return std::nullopt;
        return std::move(content.bytes);
    };
}

}  // namespace weft
