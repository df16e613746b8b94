#include "viewer/hostile_run.h"

#include <gtest/gtest.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <array>
#include <regex>
#include <sstream>

namespace weft::test {

void expect_refused_cheaply(const RunResult& run, const std::vector<std::string>& wanted) {
    EXPECT_EQ(run.exit_code, 3) << run.text();
    EXPECT_LE(run.wall_s, 5.0) << run.text();
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

std::optional<TracedRun> run_weft_traced(const std::vector<std::string>& arguments,
                                         const std::filesystem::path& folder) {
    const ScratchFolder scratch;
    const std::string log = scratch / "trace";
    std::vector<std::string> words{"strace", "-f", "-qq",       "-s", "4096", "-e", "trace=%file,%network",
                                   "-o",     log,  WEFT_PROGRAM};
    words.insert(words.end(), arguments.begin(), arguments.end());
    // The leak checker is a tracer itself.
    TracedRun traced{run_program(words, {{"ASAN_OPTIONS", "detect_leaks=0"}}, folder), {}, {}, false};
    std::istringstream lines(read_text(log));
    const std::regex call(R"re((openat?|execve)\((?:[^",]*, )?"([^"]*)".*= (-?\d+))re");
    std::smatch parts;
    for (std::string line; std::getline(lines, line);) {
        traced.used_network = traced.used_network || line.find("AF_INET") != std::string::npos;
        if (!std::regex_search(line, parts, call) || parts[3].str().front() == '-') continue;
        if (parts[1] == "execve") {
            traced.executed.push_back(parts[2]);
            continue;
        }
        std::error_code error;
        const std::filesystem::path path = folder / parts[2].str();
        const std::filesystem::path real = std::filesystem::canonical(path, error);
        traced.opened.push_back((error ? path : real).string());
    }
    if (traced.executed.empty()) return std::nullopt;
    return traced;
}

}  // namespace weft::test
