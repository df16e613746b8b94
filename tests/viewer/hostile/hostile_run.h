// The required result for every hostile file: exit code 3 with a place and a remedy, within 5 s and 1 GiB,
// and no file opened outside its folder.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tests/viewer/program.h"

namespace weft::test {

// `wanted`: texts that the message must contain.
void expect_refused_cheaply(const RunResult& run, const std::vector<std::string>& wanted);

// A folder that must not be read, watched with inotify, which needs no privileges and works in any container.
class WatchedFolder {
 public:
    explicit WatchedFolder(const std::filesystem::path& folder);
    ~WatchedFolder();
    WatchedFolder(const WatchedFolder&) = delete;
    WatchedFolder& operator=(const WatchedFolder&) = delete;

    // True if the folder or a file in it was opened since the last call.
    [[nodiscard]] bool was_opened();

 private:
    int inotify_ = -1;
};

// Runs the same command under strace. nullopt if strace is missing or may not trace.
struct TracedRun {
    RunResult run;
    std::vector<std::string> opened;    // absolute paths with links resolved
    std::vector<std::string> executed;  // started programs, including the first
    bool used_network = false;
};
[[nodiscard]] std::optional<TracedRun> run_weft_traced(const std::vector<std::string>& arguments,
                                                       const std::filesystem::path& folder);

}  // namespace weft::test
