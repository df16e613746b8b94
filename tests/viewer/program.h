// Runs the `weft` program as a user does, and measures its processor time and memory. Names of numbers end
// with their units.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace weft::test {

struct RunResult {
    // Exit code of the program; 128 + the number of the signal if a signal killed the program.
    int exit_code = -1;
    std::string out;
    std::string err;
    // Processor time of the program and its child processes, in seconds. Unlike the elapsed time, it hardly
    // depends on the load of the machine.
    double cpu_s = 0;
    // Peak resident memory in bytes of the process that used the most: the program itself or one of its child
    // processes.
    uint64_t max_rss_bytes = 0;

    // Returns the exit code, time, memory and output as one text for failure messages.
    [[nodiscard]] std::string text() const;
};

// Limits of processor time and of elapsed time for one program, in seconds. They are much higher than any
// test needs, so only a program that hangs exceeds them. No test result depends on elapsed time.
inline constexpr unsigned kMostCpu_s = 1200;
inline constexpr unsigned kMostWall_s = 1500;

// Limits of processor time in seconds and of memory in bytes. `weft` must stay within them for every input,
// even if the input is faulty.
inline constexpr double kMostInputCpu_s = 5;
inline constexpr uint64_t kMostInputMemory_bytes = uint64_t{1} << 30;

// The path of a shipped graph that many tests use.
inline constexpr const char* kDeferredGraph = WEFT_SOURCE_DIR "/graphs/deferred.json";

// Restores the default actions of signals in a child process. A shell ignores some signals in background
// jobs, and a child would inherit this, so that the signals could not end it.
void reset_signals();
// Sets the limits of processor time and elapsed time. Call it in a child process before exec, which keeps the
// limits.
void limit_time(unsigned most_cpu_s = kMostCpu_s);

// Adds `--graph deferred.json`, `--timeout 1200` (kMostCpu_s, in seconds) and `--probes none` to the commands
// `render` and `view`, unless the arguments contain these options. With the default of 60 s, a frame can fail
// on a very busy machine. With one frame and without probes, pictures take less time.
[[nodiscard]] std::vector<std::string> with_test_options(std::vector<std::string> arguments);

using Environment = std::vector<std::pair<std::string, std::string>>;

// Runs `weft` with with_test_options(arguments) and waits for its end. An empty `folder` means the current
// folder of the test. `environment` is added to the environment of the test. The program is killed after
// kMostCpu_s of processor time, or after kMostWall_s of elapsed time.
[[nodiscard]] RunResult run_weft(const std::vector<std::string>& arguments,
                                 const Environment& environment = {},
                                 const std::filesystem::path& folder = {});

// Runs any program in the same way as run_weft(), with unchanged arguments. The first word is the path or
// name of the program.
[[nodiscard]] RunResult run_program(const std::vector<std::string>& words,
                                    const Environment& environment = {},
                                    const std::filesystem::path& folder = {});

// Creates an empty temporary folder, and removes it with its content in the destructor.
class ScratchFolder {
 public:
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    [[nodiscard]] std::string operator/(const std::string& name) const { return (path_ / name).string(); }
    void write(const std::string& name, const std::string& content) const;

 private:
    std::filesystem::path path_;
};

[[nodiscard]] std::string read_text(const std::filesystem::path& path);

// Expects that a text contains each of the parts.
void expect_parts(const std::string& text, const std::vector<std::string>& parts);

// Returns true if the environment variable WEFT_EXTENDED asks for the complete test matrices.
[[nodiscard]] bool extended();

// Returns true if a Vulkan device is available. Otherwise, tests that need a device are skipped.
[[nodiscard]] bool has_device();

}  // namespace weft::test
