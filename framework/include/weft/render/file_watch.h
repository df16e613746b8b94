// Purpose: waits for files to change: written in place, replaced by a rename as most editors do, removed and
// made again, also along with a folder above them. Nothing is polled: inotify watches the folders, so that a
// file that isn't there yet can be waited for too. Errors: X580 the system gives no watch.
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
    // After a change it waits until there was none for `quiet`: who saves writes more than once.
    [[nodiscard]] static Result<std::unique_ptr<FileWatch>> create(
        std::chrono::milliseconds quiet = std::chrono::milliseconds(50));
    ~FileWatch();
    FileWatch(const FileWatch&) = delete;
    FileWatch& operator=(const FileWatch&) = delete;

    // From now on these, absolute, there or not. True: folders are watched that were not before, so what was
    // read of them until now may have changed unseen.
    [[nodiscard]] bool watch(const std::set<std::filesystem::path>& files);
    // True: some of the files may have changed, since the last time or since watch(). False: wake() was
    // called.
    [[nodiscard]] bool wait();
    // Ends a wait(), or the next one. From any thread.
    void wake();
    // Folders that hold such files and can't be watched: too many watches, or no right to read them.
    [[nodiscard]] const std::set<std::filesystem::path>& unwatched() const { return unwatched_; }

 private:
    enum class Stir : uint8_t { nothing, change, call };
    FileWatch(int events, int call, std::chrono::milliseconds quiet)
        : events_(events), call_(call), quiet_(quiet) {}
    // What happens within `timeout_ms`, or ever (-1).
    [[nodiscard]] Stir next(int timeout_ms);
    [[nodiscard]] bool read_events();

    // What is of interest in one watched folder.
    struct Folder {
        std::filesystem::path path;
        std::set<std::string> names;
    };
    int events_;
    int call_;
    std::chrono::milliseconds quiet_;
    std::map<int, Folder> folders_;  // by watch
    std::set<std::filesystem::path> unwatched_;
};

}  // namespace weft::render
