#include "graph/syntax/contained_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <optional>
#include <system_error>

namespace weft {
namespace {

namespace fs = std::filesystem;

class OpenFile {
 public:
    OpenFile(const fs::path& path, int flags) : descriptor_(open(path.c_str(), flags)) {}
    ~OpenFile() {
        if (descriptor_ >= 0) close(descriptor_);
    }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;
    [[nodiscard]] int get() const { return descriptor_; }

 private:
    int descriptor_;
};

// Reads a file into `room` until the end of the file or of `room`. Returns the number of bytes read, or
// nullopt if reading fails.
std::optional<uint64_t> read_all(int descriptor, std::span<std::byte> room) {
    size_t have = 0;
    while (have < room.size()) {
        const ssize_t got = read(descriptor, room.data() + have, room.size() - have);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return std::nullopt;
        if (got == 0) break;
        have += static_cast<size_t>(got);
    }
    return have;
}

}  // namespace

fs::path real_folder(const fs::path& folder) {
    std::error_code failed;
    fs::path real = fs::canonical(folder.empty() ? fs::path(".") : folder, failed);
    return failed ? fs::path() : real;
}

bool climbs_out(const fs::path& relative) {
    if (relative.is_absolute()) return true;
    int depth = 0;
    for (const fs::path& part : relative) {
        if (part == "..") {
            if (--depth < 0) return true;
        } else if (part != "." && !part.empty()) {
            ++depth;
        }
    }
    return false;
}

bool lies_below(const fs::path& file, const fs::path& folder) {
    if (folder.empty()) return false;
    const auto [end, rest] = std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
    return end == folder.end() && rest != file.end();
}

RealFile find_real_file(const fs::path& path, std::span<const fs::path> folders) {
    std::error_code failed;
    RealFile found{fs::canonical(path, failed), false};
    if (failed) return {};
    found.is_inside =
        std::ranges::any_of(folders, [&](const fs::path& folder) { return lies_below(found.path, folder); });
    return found;
}

PlainRead read_plain_file(const fs::path& path, uint64_t most_bytes, LastLink link,
                          const std::function<std::span<std::byte>(uint64_t)>& room) {
    const bool follows = link == LastLink::followed;
    struct stat status {};
    if ((follows ? stat(path.c_str(), &status) : lstat(path.c_str(), &status)) != 0)
        return {0, FileFault::missing};
    if (!S_ISREG(status.st_mode)) return {0, FileFault::not_plain};
    // Another file may take this path between stat() and open(), so the file type and size are checked again,
    // with fstat() on the open descriptor.
    const OpenFile file(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY | (follows ? 0 : O_NOFOLLOW));
    if (file.get() < 0 || fstat(file.get(), &status) != 0) return {0, FileFault::unreadable};
    if (!S_ISREG(status.st_mode)) return {0, FileFault::not_plain};
    const auto size = static_cast<uint64_t>(status.st_size);
    if (size > most_bytes) return {size, FileFault::too_large};
    const std::optional<uint64_t> have = read_all(file.get(), room(size));
    return have ? PlainRead{*have, FileFault::none} : PlainRead{0, FileFault::unreadable};
}

FileContent read_plain_file(const fs::path& path, uint64_t most_bytes, LastLink link) {
    FileContent content;
    const PlainRead read = read_plain_file(path, most_bytes, link, [&](uint64_t size) {
        content.bytes.resize(size);
        return std::as_writable_bytes(std::span(content.bytes));
    });
    content.fault = read.fault;
    // The file may have become shorter between reading its size and reading its content.
    content.bytes.resize(read.fault == FileFault::none ? read.size_bytes : 0);
    return content;
}

}  // namespace weft
