// Purpose: waits for changes of files. It notices that a file is written in place, replaced by renaming (as
// most editors do), removed or created again. It also notices that a parent folder is moved, removed or
// created. It uses inotify on folders, not polling. So it can also wait for files that do not exist yet.
// Errors: X580 (the system provides no more inotify instances).
#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>

#include "weft/result.h"

namespace weft::render {

class FileWatch {
 public:
    // Programs often write a file several times. So after a change, wait() returns only when no file has
    // changed for the time `quiet`, but at the latest after about 1 s.
    [[nodiscard]] static Result<std::unique_ptr<FileWatch>> create(
        std::chrono::milliseconds quiet = std::chrono::milliseconds(50));
    ~FileWatch();
    FileWatch(const FileWatch&) = delete;
    FileWatch& operator=(const FileWatch&) = delete;

    // Sets the files to watch: absolute paths, existing or not. Returns true if folders are watched that were
    // not watched before. In that case, files that the caller has read before this call may have changed
    // unnoticed.
    [[nodiscard]] bool watch(const std::set<std::filesystem::path>& files);
    // Waits for a change. Returns true if a file may have changed since the last call or since watch().
    // Returns false if wake() was called.
    [[nodiscard]] bool wait();
    // Makes the current call of wait() return, or the next call if none is running. May be called from any
    // thread.
    void wake();
    // Returns the folders that cannot be watched, because there are too many watches or because of missing
    // permissions.
    [[nodiscard]] const std::set<std::filesystem::path>& unwatched() const { return unwatched_; }

 private:
    // The result of next(). nothing: the time is over, or the event does not matter; change: a watched file
    // changed; call: wake() was called.
    enum class Stir : uint8_t { nothing, change, call };
    FileWatch(int events, int call, std::chrono::milliseconds quiet)
        : events_(events), call_(call), quiet_(quiet) {}
    // Waits for an event, at most `timeout_ms` milliseconds; -1 means without limit.
    [[nodiscard]] Stir next(int timeout_ms);
    [[nodiscard]] bool read_events();

    // The names of watched files and subfolders in one folder.
    struct Folder {
        std::filesystem::path path;
        std::set<std::string> names;
    };
    int events_;  // Descriptor of the inotify instance.
    int call_;    // Descriptor of the eventfd that wake() writes.
    std::chrono::milliseconds quiet_;
    // The watched folders by their inotify watch descriptor.
    std::map<int, Folder> folders_;
    std::set<std::filesystem::path> unwatched_;
};

}  // namespace weft::render
