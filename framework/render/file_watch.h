// Purpose: waits for changes of files: written in place, replaced by renaming as most editors do, removed and
// created again, also together with a parent folder. It uses inotify on folders instead of polling, so it can
// also wait for files that do not exist yet. Errors: X580 the system provides no watch.
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
    // After a change it waits until no change happens for `quiet`, because programs often write a file
    // several times.
    [[nodiscard]] static Result<std::unique_ptr<FileWatch>> create(
        std::chrono::milliseconds quiet = std::chrono::milliseconds(50));
    ~FileWatch();
    FileWatch(const FileWatch&) = delete;
    FileWatch& operator=(const FileWatch&) = delete;

    // Sets the files to watch: absolute paths, existing or not. Returns true if new folders are watched, so
    // that files read before may have changed unnoticed.
    [[nodiscard]] bool watch(const std::set<std::filesystem::path>& files);
    // Returns true if a file may have changed since the last call or since watch(); false if wake() was
    // called.
    [[nodiscard]] bool wait();
    // Ends a current wait() or the next one. May be called from any thread.
    void wake();
    // Folders that cannot be watched: too many watches, or no permission to read them.
    [[nodiscard]] const std::set<std::filesystem::path>& unwatched() const { return unwatched_; }

 private:
    enum class Stir : uint8_t { nothing, change, call };
    FileWatch(int events, int call, std::chrono::milliseconds quiet)
        : events_(events), call_(call), quiet_(quiet) {}
    // Waits for an event for at most `timeout_ms`; -1: without limit.
    [[nodiscard]] Stir next(int timeout_ms);
    [[nodiscard]] bool read_events();

    // The watched names in one folder.
    struct Folder {
        std::filesystem::path path;
        std::set<std::string> names;
    };
    int events_;
    int call_;
    std::chrono::milliseconds quiet_;
    std::map<int, Folder> folders_;  // index: watch descriptor
    std::set<std::filesystem::path> unwatched_;
};

}  // namespace weft::render
