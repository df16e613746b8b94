#include "render/file_watch.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/inotify.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

namespace weft::render {

namespace fs = std::filesystem;

namespace {

// The events that are watched. IN_MODIFY is not among them, because a file that is still being written should
// not be read yet.
constexpr uint32_t kMask =
    IN_CLOSE_WRITE | IN_CREATE | IN_DELETE | IN_MOVED_FROM | IN_MOVED_TO | IN_ATTRIB | IN_ONLYDIR;
// wait() returns at most about this long after the first change, even if files change without a pause.
constexpr auto kMostPatience = std::chrono::seconds(1);

bool is_of_a_folder_itself(const inotify_event& event) {
    return (event.mask & IN_ISDIR) != 0 && (event.mask & IN_ATTRIB) != 0;
}

// True if the event is the creation of a file whose content will come later. A plain file that a program has
// just created is empty, and closing it causes another event. A file that was created by link() already has
// its content and causes no other event.
bool is_still_to_come(const inotify_event& event, const fs::path& file) {
    if ((event.mask & IN_CREATE) == 0 || (event.mask & IN_ISDIR) != 0) return false;
    struct stat status {};
    return lstat(file.c_str(), &status) == 0 && S_ISREG(status.st_mode) && status.st_nlink == 1 &&
           status.st_size == 0;
}

}  // namespace

Result<std::unique_ptr<FileWatch>> FileWatch::create(std::chrono::milliseconds quiet) {
    const int events = inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
    const int call = events < 0 ? -1 : eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC);
    if (call < 0) {
        Diagnostic error;
        error.code = "X580";
        error.message = std::string("the system does not allow watching more files: ") + std::strerror(errno);
        error.help = {"end other programs that watch files, or raise fs.inotify.max_user_instances"};
        if (events >= 0) close(events);
        return error;
    }
    return std::unique_ptr<FileWatch>(new FileWatch(events, call, quiet));
}

FileWatch::~FileWatch() {
    close(events_);
    close(call_);
}

bool FileWatch::watch(const std::set<fs::path>& files) {
    // Parent folders are watched too, because moving a folder away moves the files in it.
    std::map<fs::path, std::set<std::string>> wanted;
    for (const fs::path& file : files)
        for (fs::path at = file; at.has_relative_path(); at = at.parent_path())
            if (!wanted[at.parent_path()].insert(at.filename().string()).second) break;
    std::map<int, Folder> folders;
    bool grew = false;
    unwatched_.clear();
    for (auto& [path, names] : wanted) {
        const int watched = inotify_add_watch(events_, path.c_str(), kMask);
        if (watched < 0) {
            const int why = errno;
            // Report only folders that contain a watched file. The folders above them are watched only to
            // notice that someone moves or removes them.
            const bool holds_file =
                std::ranges::any_of(files, [&](const fs::path& file) { return file.parent_path() == path; });
            if (why != ENOENT && why != ENOTDIR && holds_file) unwatched_.insert(path);
            continue;
        }
        grew |= !folders_.contains(watched);
        Folder& folder = folders[watched];
        folder.path = path;
        folder.names.merge(names);
    }
    for (const auto& [watched, folder] : folders_)
        if (!folders.contains(watched)) inotify_rm_watch(events_, watched);
    folders_ = std::move(folders);
    return grew;
}

bool FileWatch::read_events() {
    alignas(inotify_event) std::array<char, 16 * 1024> buffer{};
    bool changed = false;
    for (;;) {
        const ssize_t bytes = read(events_, buffer.data(), buffer.size());
        if (bytes < 0 && errno == EINTR) continue;
        if (bytes <= 0) return changed;
        for (size_t at = 0; at < static_cast<size_t>(bytes);) {
            inotify_event event{};
            std::memcpy(&event, buffer.data() + at, sizeof event);
            const std::string name(event.len > 0 ? buffer.data() + at + sizeof event : "");
            at += sizeof event + event.len;
            if ((event.mask & IN_Q_OVERFLOW) != 0) changed = true;
            const auto folder = folders_.find(event.wd);
            if (folder == folders_.end()) continue;
            if (folder->second.names.contains(name) && !is_of_a_folder_itself(event) &&
                !is_still_to_come(event, folder->second.path / name))
                changed = true;
            // The folder does not exist any more, and neither does its inotify watch. If a folder with the
            // same name is created later, watch() must add it as a new folder.
            if ((event.mask & IN_IGNORED) != 0) folders_.erase(folder);
        }
    }
}

FileWatch::Stir FileWatch::next(int timeout_ms) {
    std::array<pollfd, 2> sources{pollfd{call_, POLLIN, 0}, pollfd{events_, POLLIN, 0}};
    const int ready = poll(sources.data(), sources.size(), timeout_ms);
    if (ready <= 0) return Stir::nothing;
    if ((sources[0].revents & POLLIN) != 0) {
        uint64_t calls = 0;
        static_cast<void>(!read(call_, &calls, sizeof calls));
        return Stir::call;
    }
    return read_events() ? Stir::change : Stir::nothing;
}

bool FileWatch::wait() {
    using Clock = std::chrono::steady_clock;
    Stir stir = Stir::nothing;
    while (stir == Stir::nothing) stir = next(-1);
    if (stir == Stir::call) return false;
    const Clock::time_point patience = Clock::now() + kMostPatience;
    Clock::time_point quiet_from = Clock::now();
    while (Clock::now() < patience) {
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(quiet_from + quiet_ - Clock::now());
        if (left.count() <= 0) break;
        stir = next(static_cast<int>(left.count()));
        if (stir == Stir::call) return false;
        if (stir == Stir::change) quiet_from = Clock::now();
    }
    return true;
}

void FileWatch::wake() {
    const uint64_t one = 1;
    static_cast<void>(!write(call_, &one, sizeof one));
}

}  // namespace weft::render
