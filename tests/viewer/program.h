// Runs the `weft` program as a user does, and measures its time and memory. Names contain the units.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace weft::test {

struct RunResult {
    int exit_code = -1;  // 128 + signal if it was killed
    std::string out;
    std::string err;
    double cpu_s = 0;            // CPU time including all child processes; it does not depend on the load of
                                 // the machine
    uint64_t max_rss_bytes = 0;  // of the largest process, including child processes

    // Output as text for failure messages.
    [[nodiscard]] std::string text() const;
};

// Much higher than any test needs, so that only a hanging program exceeds them. No test result depends on
// elapsed real time.
inline constexpr unsigned kMostCpu_s = 1200;
inline constexpr unsigned kMostWall_s = 1500;

// For a child: signals end it, also where the tests run in the background, in which a shell ignores some of
// them.
void reset_signals();
// Sets the limits above; call it in a child before exec, which keeps them.
void limit_time(unsigned most_cpu_s = kMostCpu_s);

using Environment = std::vector<std::pair<std::string, std::string>>;

// `environment` is added to the test's environment. The program is killed after kMostCpu_s of CPU time, or
// kMostWall_s if it sleeps.
[[nodiscard]] RunResult run_weft(const std::vector<std::string>& arguments,
                                 const Environment& environment = {},
                                 const std::filesystem::path& folder = {});

// Runs any program, given by path or name; otherwise as above.
[[nodiscard]] RunResult run_program(const std::vector<std::string>& words,
                                    const Environment& environment = {},
                                    const std::filesystem::path& folder = {});

// An empty folder, removed in the destructor.
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

// True if the complete test matrices shall run (WEFT_EXTENDED).
[[nodiscard]] bool extended();

// True if a Vulkan device is available; tests that need one are skipped otherwise.
[[nodiscard]] bool has_device();

}  // namespace weft::test
