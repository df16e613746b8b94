#include "load/file_stamps.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace weft {
namespace {

// The file system's clock advances in ticks, and two changes in one tick get the same time. So if a file
// changed less than a tick before the reading began, a second change may leave its stamp the same. The
// longest tick of Linux is 10 ms; this value has a margin.
constexpr int64_t kTickNs = 50'000'000;

int64_t nanoseconds(const timespec& time) {
    return int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

}  // namespace

FileStamps::FileStamps()
    : begun_ns_(std::chrono::duration_cast<std::chrono::nanoseconds>(
                    std::chrono::system_clock::now().time_since_epoch())
                    .count()) {}

FileStamps::Stamp FileStamps::stamp_of(const std::filesystem::path& path) {
    Stamp stamp;
    struct stat status {};
    if (stat(path.c_str(), &status) != 0) return stamp;
    stamp.exists = true;
    stamp.device = status.st_dev;
    stamp.inode = status.st_ino;
    stamp.size_bytes = status.st_size;
    stamp.modified_ns = nanoseconds(status.st_mtim);
    stamp.changed_ns = nanoseconds(status.st_ctim);
    return stamp;
}

void FileStamps::add(const std::filesystem::path& path) {
    if (stamps_.contains(path)) return;
    const Stamp& stamp = stamps_.emplace(path, stamp_of(path)).first->second;
    if (stamp.exists) {
        sure_ = sure_ && std::max(stamp.modified_ns, stamp.changed_ns) < begun_ns_ - kTickNs;
    } else if (path.has_relative_path()) {
        // The file may have existed while the files were read, and was removed before this stamp. Its removal
        // changed the folder, so the stamp of the folder shows this.
        add(path.parent_path());
    }
}

void FileStamps::take(const std::set<std::filesystem::path>& files) {
    sure_ = true;
    for (const std::filesystem::path& file : files) add(file);
}

bool FileStamps::hold() const {
    return sure_ && std::ranges::all_of(stamps_, [](const auto& entry) {
               return entry.second == stamp_of(entry.first);
           });
}

}  // namespace weft
