// Checks the result that is required for every hostile file: exit code 3, a message with a place and a
// remedy, at most 5 s of processor time and 1 GiB of memory, and no opened file outside the allowed folder.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tests/viewer/program.h"

namespace weft::test {

// Expects that the program refused its input with exit code 3 and a help text, within 5 s of processor time
// and 1 GiB of memory. The output on stderr must be at most 1 MiB and contain each text of `wanted`.
void expect_refused_cheaply(const RunResult& run, const std::vector<std::string>& wanted);

// Watches a folder that the program must not read. The class uses inotify, which needs no privileges and
// works in any container.
class WatchedFolder {
 public:
    explicit WatchedFolder(const std::filesystem::path& folder);
    ~WatchedFolder();
    WatchedFolder(const WatchedFolder&) = delete;
    WatchedFolder& operator=(const WatchedFolder&) = delete;

    // True if the folder or a file in it was opened or read since the last call (at the first call: since the
    // constructor).
    [[nodiscard]] bool was_opened();

 private:
    int inotify_ = -1;
};

// Result of run_weft_traced(), which runs `weft` under strace. The function returns nullopt if strace is
// missing or is not allowed to trace.
struct TracedRun {
    RunResult run;
    // Absolute paths of the opened files, with links resolved.
    std::vector<std::string> opened;
    // Paths of the started programs, including `weft` itself.
    std::vector<std::string> executed;
    bool used_network = false;
};
[[nodiscard]] std::optional<TracedRun> run_weft_traced(const std::vector<std::string>& arguments,
                                                       const std::filesystem::path& folder);

}  // namespace weft::test
