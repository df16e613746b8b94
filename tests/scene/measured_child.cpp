#include "tests/scene/measured_child.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <string>

namespace weft::test {
namespace {

constexpr int kThrew = 255;

// Returns a memory field of /proc/self/status, in bytes. The peak is read from VmHWM (peak resident memory)
// because VmHWM can be reset; ru_maxrss of a child process starts with the value of its parent.
uint64_t resident_bytes(const char* field) {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with(field)) return std::stoull(line.substr(line.find(':') + 1)) * 1024;
    return 0;
}

[[noreturn]] void run(const std::function<int()>& work, int report) {
    // Writing 5 to clear_refs resets VmHWM to the current resident memory.
    std::ofstream("/proc/self/clear_refs") << "5";
    const uint64_t before = resident_bytes("VmRSS");
    int answer = kThrew;
    try {
        answer = work();
    } catch (const std::exception&) {
        answer = kThrew;
    }
    const uint64_t most = resident_bytes("VmHWM");
    const uint64_t grown = most > before ? most - before : 0;
    const bool told = write(report, &grown, sizeof grown) == sizeof grown;
    _exit(told ? answer : kThrew);
}

}  // namespace

Cost cost_of(const std::function<int()>& work) {
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("pipe failed");
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("fork failed");
    if (child == 0) run(work, ends[1]);
    close(ends[1]);
    Cost cost;
    const bool told = read(ends[0], &cost.grown_bytes, sizeof cost.grown_bytes) == sizeof cost.grown_bytes;
    close(ends[0]);
    int status = 0;
    rusage usage{};
    while (wait4(child, &status, 0, &usage) < 0 && errno == EINTR) {
    }
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_usec) * 1e-6;
    };
    cost.cpu_s = seconds(usage.ru_utime) + seconds(usage.ru_stime);
    cost.finished = told && WIFEXITED(status) && WEXITSTATUS(status) != kThrew;
    if (WIFEXITED(status)) cost.answer = WEXITSTATUS(status);
    return cost;
}

}  // namespace weft::test
