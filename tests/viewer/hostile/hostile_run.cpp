#include "tests/viewer/hostile/hostile_run.h"

#include <gtest/gtest.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <regex>
#include <sstream>
#include <utility>

namespace weft::test {

void expect_refused_cheaply(const RunResult& run, const std::vector<std::string>& wanted) {
    EXPECT_EQ(run.exit_code, 3) << run.text();
    EXPECT_LE(run.cpu_s, 5.0) << run.text();
    EXPECT_LE(run.max_rss_bytes, uint64_t{1} << 30) << run.text();
    EXPECT_NE(run.err.find("\n  help: "), std::string::npos) << run.text();
    EXPECT_LE(run.err.size(), 1u << 20) << "a message for each of a million faults helps nobody";
    for (const std::string& part : wanted)
        EXPECT_NE(run.err.find(part), std::string::npos) << "wanted: " << part << "\n" << run.text();
}

WatchedFolder::WatchedFolder(const std::filesystem::path& folder) : inotify_(inotify_init1(IN_NONBLOCK)) {
    EXPECT_GE(inotify_add_watch(inotify_, folder.c_str(), IN_OPEN | IN_ACCESS), 0);
}

WatchedFolder::~WatchedFolder() {
    close(inotify_);
}

bool WatchedFolder::was_opened() {
    std::array<char, 4096> events;
    bool any = false;
    while (read(inotify_, events.data(), events.size()) > 0) any = true;
    return any;
}

namespace {

// Returns the logs of strace. There is one log per thread, so that no log entry is split by a call of another
// thread. The log of the first thread comes first.
std::vector<std::filesystem::path> logs_in(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> logs;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) logs.push_back(entry.path());
    std::ranges::sort(logs, {}, [](const std::filesystem::path& log) {
        const bool is_first = read_text(log).find("execve(\"" WEFT_PROGRAM "\"") != std::string::npos;
        return std::pair(!is_first, log);
    });
    return logs;
}

// Collects the opened files, the started programs and the use of the network from a log. The pattern matches
// lines such as "openat(AT_FDCWD</folder>, "name", …) = 3</folder/name>".
void read_log(const std::filesystem::path& log, TracedRun& traced) {
    static const std::regex call(
        R"re(^(open|openat|openat2|creat|execve)\((?:[A-Z_0-9]+<([^>]*)>, )?"([^"]*)".* = (-?\d+)(?:<([^>]*)>)?)re");
    std::istringstream lines(read_text(log));
    std::smatch parts;
    for (std::string line; std::getline(lines, line);) {
        traced.used_network = traced.used_network || line.find("AF_INET") != std::string::npos;
        if (!std::regex_search(line, parts, call) || parts[4].str().front() == '-') continue;
        if (parts[1] == "execve") {
            traced.executed.push_back(parts[3]);
            continue;
        }
        // strace shows the file of the returned descriptor with all links resolved. A deleted file appears as
        // "…/#17 (deleted)".
        traced.opened.push_back(parts[5].matched ? parts[5].str() : parts[3].str());
    }
}

}  // namespace

std::optional<TracedRun> run_weft_traced(const std::vector<std::string>& arguments,
                                         const std::filesystem::path& folder) {
    const ScratchFolder scratch;
    std::filesystem::create_directory(scratch / "logs");
    std::vector<std::string> words{"strace",    "-ff",
                                   "-y",        "-qq",
                                   "-s",        "4096",
                                   "-e",        "trace=%file,%network",
                                   "-o",        scratch / "logs/log",
                                   WEFT_PROGRAM};
    words.insert(words.end(), arguments.begin(), arguments.end());
    // LeakSanitizer cannot run under strace, because both of them use ptrace.
    TracedRun traced{run_program(words, {{"ASAN_OPTIONS", "detect_leaks=0"}}, folder), {}, {}, false};
    for (const std::filesystem::path& log : logs_in(scratch.path() / "logs")) read_log(log, traced);
    if (traced.executed.empty()) return std::nullopt;
    return traced;
}

}  // namespace weft::test
