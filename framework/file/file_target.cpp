#include "file/file_target.h"

#include <fcntl.h>
#include <linux/magic.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>

namespace weft {
namespace {

namespace fs = std::filesystem;
constexpr int kMostLinks = 40;  // The largest number of links to follow; the Linux kernel has the same limit.

// Returns true if the folder is in the /proc file system. Entries of /proc/self/fd look like links, but their
// targets need not be paths (example: "pipe:[4711]"), so they must not be followed.
bool is_in_proc(const fs::path& folder) {
    struct statfs system {};
    return statfs(folder.c_str(), &system) == 0 && system.f_type == PROC_SUPER_MAGIC;
}

// Returns the number of the descriptor of this process that the path names; -1 if the path names none.
int own_descriptor(const fs::path& path) {
    std::error_code error;
    const fs::path folder = fs::canonical(path.parent_path(), error);
    const fs::path own = fs::path("/proc") / std::to_string(getpid()) / "fd";
    if (error || folder != own) return -1;
    const std::string name = path.filename().string();
    int number = -1;
    const auto [end, fault] = std::from_chars(name.data(), name.data() + name.size(), number);
    return fault == std::errc{} && end == name.data() + name.size() ? number : -1;
}

bool is_link(const fs::path& path) {
    struct stat status {};
    return lstat(path.c_str(), &status) == 0 && S_ISLNK(status.st_mode);
}

TargetKind kind_of(const std::optional<struct stat>& old) {
    if (!old || S_ISREG(old->st_mode)) return TargetKind::file;
    return S_ISDIR(old->st_mode) ? TargetKind::folder : TargetKind::stream;
}

// Follows a link at the end of the path, and repeats this while the result is a link too. Links in the middle
// of the path need no treatment, because the kernel resolves them.
FileTarget follow_links(fs::path at) {
    FileTarget target;
    for (int links = 0; is_link(at); ++links) {
        const fs::path folder = at.has_parent_path() ? at.parent_path() : ".";
        if (is_in_proc(folder)) {
            target.descriptor = own_descriptor(at);
            target.kind = target.descriptor >= 0 ? TargetKind::descriptor : TargetKind::stream;
            break;
        }
        std::error_code error;
        const fs::path next = fs::read_symlink(at, error);
        if (error || links == kMostLinks) {
            target.error = error ? error.value() : ELOOP;
            break;
        }
        at = next.is_absolute() ? next : folder / next;
    }
    target.path = std::move(at);
    return target;
}

}  // namespace

FileTarget find_target(const std::string& path) {
    FileTarget target = follow_links(path);
    if (target.error != 0 || target.kind == TargetKind::descriptor) return target;
    struct stat status {};
    if (stat(target.path.c_str(), &status) == 0)
        target.old = status;
    else if (errno != ENOENT)
        target.error = errno;
    if (target.kind == TargetKind::file) target.kind = kind_of(target.old);
    // If the path ends with "/", it names a folder. This folder does not exist, because kind_of() has already
    // given an existing folder the kind TargetKind::folder.
    if (target.kind == TargetKind::file && !target.path.has_filename()) target.kind = TargetKind::folder;
    return target;
}

}  // namespace weft
