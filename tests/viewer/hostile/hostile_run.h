// What every hostile file must end in: exit code 3 with a place and a remedy, within 5 s and 1 GiB, and
// nothing outside of its folder opened.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tests/viewer/program.h"

namespace weft::test {

// `wanted`: parts of the message.
void expect_refused_cheaply(const RunResult& run, const std::vector<std::string>& wanted);

// A folder that nobody may look into, watched with inotify: it needs no rights, and works in any container.
class WatchedFolder {
 public:
    explicit WatchedFolder(const std::filesystem::path& folder);
    ~WatchedFolder();
    WatchedFolder(const WatchedFolder&) = delete;
    WatchedFolder& operator=(const WatchedFolder&) = delete;

    // True when it, or a file in it, was opened since the last call.
    [[nodiscard]] bool was_opened();

 private:
    int inotify_ = -1;
};

// The same run again under strace. Nothing when strace is not there or may not trace.
struct TracedRun {
    RunResult run;
    std::vector<std::string> opened;    // absolute, links resolved
    std::vector<std::string> executed;  // programs that were started, the first one included
    bool used_network = false;
};
[[nodiscard]] std::optional<TracedRun> run_weft_traced(const std::vector<std::string>& arguments,
                                                       const std::filesystem::path& folder);

}  // namespace weft::test
