#include "tests/viewer/program.h"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>

namespace weft::test {
namespace {

double seconds(const timeval& time) {
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
}

// Replaces the forked child process by the program: connects stdin, stdout and stderr, sets the environment,
// and calls exec. The function never returns. If a call fails, it ends the child with exit code 126 or 127.
[[noreturn]] void become(std::vector<char*>& arguments, const Environment& environment,
                         const std::filesystem::path& folder, const char* out, const char* err) {
    const int out_file = open(out, O_WRONLY | O_CREAT | O_TRUNC, 0600);
    const int err_file = open(err, O_WRONLY | O_CREAT | O_TRUNC, 0600);
    const int nothing = open("/dev/null", O_RDONLY);
    const bool ready = dup2(nothing, 0) >= 0 && dup2(out_file, 1) >= 0 && dup2(err_file, 2) >= 0;
    for (const auto& [name, value] : environment) setenv(name.c_str(), value.c_str(), 1);
    if (!ready || (!folder.empty() && chdir(folder.c_str()) != 0)) _exit(126);
    reset_signals();
    limit_time();
    execvp(arguments.front(), arguments.data());
    _exit(127);
}

}  // namespace

void reset_signals() {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE}) std::signal(signal, SIG_DFL);
}

void limit_time(unsigned most_cpu_s) {
    rlimit limit{};
    // The hard limit keeps its value: `weft` sets a limit itself, and only root may raise a hard limit again.
    if (getrlimit(RLIMIT_CPU, &limit) == 0) {
        limit.rlim_cur = std::min<rlim_t>(most_cpu_s, limit.rlim_max);
        setrlimit(RLIMIT_CPU, &limit);
    }
    alarm(kMostWall_s);
}

std::string RunResult::text() const {
    std::ostringstream text;
    text << "exit code " << exit_code << " after " << cpu_s << " s of processor time, "
         << max_rss_bytes / 1048576 << " MiB at most\n--- stdout\n"
         << out.substr(0, 4000) << "\n--- stderr\n"
         << err.substr(0, 8000);
    return text.str();
}

std::vector<std::string> with_test_options(std::vector<std::string> arguments) {
    const bool draws = !arguments.empty() && (arguments.front() == "render" || arguments.front() == "view");
    const auto has = [&](const char* option) {
        return std::ranges::find(arguments, option) != arguments.end();
    };
    if (draws && !has("--graph")) arguments.insert(arguments.end(), {"--graph", kDeferredGraph});
    if (draws && !has("--timeout"))
        arguments.insert(arguments.end(), {"--timeout", std::to_string(kMostCpu_s)});
    if (draws && !has("--probes")) arguments.insert(arguments.end(), {"--probes", "none"});
    return arguments;
}

RunResult run_weft(const std::vector<std::string>& arguments, const Environment& environment,
                   const std::filesystem::path& folder) {
    std::vector<std::string> words = with_test_options(arguments);
    words.insert(words.begin(), WEFT_PROGRAM);
    return run_program(words, environment, folder);
}

RunResult run_program(const std::vector<std::string>& words, const Environment& environment,
                      const std::filesystem::path& folder) {
    const ScratchFolder scratch;
    const std::string out = scratch / "out", err = scratch / "err";
    std::vector<std::string> owned = words;
    std::vector<char*> pointers;
    for (std::string& word : owned) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    Environment all{{"XDG_CACHE_HOME", WEFT_TEST_CACHE}, {"MESA_SHADER_CACHE_DIR", WEFT_TEST_CACHE "/mesa"}};
    all.insert(all.end(), environment.begin(), environment.end());

    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("fork failed");
    if (child == 0) become(pointers, all, folder, out.c_str(), err.c_str());
    int status = 0;
    rusage usage{};
    while (wait4(child, &status, 0, &usage) < 0 && errno == EINTR) {
    }
    RunResult result;
    result.cpu_s = seconds(usage.ru_utime) + seconds(usage.ru_stime);
    result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    result.max_rss_bytes = static_cast<uint64_t>(usage.ru_maxrss) * 1024;
    result.out = read_text(out);
    result.err = read_text(err);
    return result;
}

ScratchFolder::ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "weft-test-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("mkdtemp failed");
    path_ = name;
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

void ScratchFolder::write(const std::string& name, const std::string& content) const {
    std::filesystem::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name, std::ios::binary) << content;
}

std::string read_text(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

bool extended() {
    const char* value = std::getenv("WEFT_EXTENDED");
    return value != nullptr && *value != '\0' && std::string(value) != "0";
}

bool has_device() {
    return run_weft({"doctor"}).exit_code == 0;
}

void expect_parts(const std::string& text, const std::vector<std::string>& parts) {
    for (const std::string& part : parts)
        EXPECT_NE(text.find(part), std::string::npos) << part << "\nis missing in\n" << text;
}

}  // namespace weft::test
