#include "tests/viewer/running_program.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <thread>

namespace weft::test {

RunningProgram::RunningProgram(const std::vector<std::string>& arguments, const Environment& environment,
                               unsigned most_cpu_s) {
    std::vector<std::string> words = with_test_options(arguments);
    words.insert(words.begin(), WEFT_PROGRAM);
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    const std::string err = scratch_ / "err";
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("pipe failed");
    child_ = fork();
    if (child_ < 0) throw std::runtime_error("fork failed");
    if (child_ == 0) {
        const int file = open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND, 0600);
        if (dup2(ends[0], 0) < 0 || dup2(file, 1) < 0 || dup2(file, 2) < 0) _exit(126);
        setenv("XDG_CACHE_HOME", WEFT_TEST_CACHE, 1);
        setenv("MESA_SHADER_CACHE_DIR", WEFT_TEST_CACHE "/mesa", 1);
        for (const auto& [name, value] : environment) setenv(name.c_str(), value.c_str(), 1);
        reset_signals();
        limit_time(most_cpu_s);
        execv(pointers.front(), pointers.data());
        _exit(127);
    }
    close(ends[0]);
    stdin_ = ends[1];
}

RunningProgram::~RunningProgram() {
    close_stdin();
    if (child_ < 0) return;
    kill(child_, SIGKILL);
    static_cast<void>(exit_code());
}

bool RunningProgram::says(const std::string& text, int times) const {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point end = Clock::now() + std::chrono::seconds(kMostWall_s);
    while (Clock::now() < end) {
        const bool over = has_ended();
        const std::string all = err();
        int found = 0;
        for (size_t at = all.find(text); at != std::string::npos; at = all.find(text, at + 1)) ++found;
        if (found >= times || over) return found >= times;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
}

bool RunningProgram::has_ended() const {
    siginfo_t info{};
    return child_ < 0 || (waitid(P_PID, static_cast<id_t>(child_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
                          info.si_pid != 0);
}

void RunningProgram::close_stdin() {
    if (stdin_ >= 0) close(stdin_);
    stdin_ = -1;
}

void RunningProgram::send(int signal) const {
    kill(child_, signal);
}

int RunningProgram::exit_code() {
    int status = 0;
    while (waitpid(child_, &status, 0) < 0 && errno == EINTR) {
    }
    child_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace weft::test
