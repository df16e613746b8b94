// Runs the `weft` program as a user does, and measures what it took. Units are in names.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace weft::test {

struct RunResult {
    int exit_code = -1;  // 128 + signal when it was killed
    std::string out;
    std::string err;
    double cpu_s = 0;            // of its own and of all processes that it waited for: the same on a busy machine
    uint64_t max_rss_bytes = 0;  // of the largest process: its own, or one that it waited for

    // For failure messages.
    [[nodiscard]] std::string text() const;
};

// Far beyond what any test needs: only a program that hangs reaches them. A verdict never depends on the wall clock.
inline constexpr unsigned kMostCpu_s = 1200;
inline constexpr unsigned kMostWall_s = 1500;

// In a child, before exec: the limits above. They survive exec.
void limit_time(unsigned most_cpu_s = kMostCpu_s);

using Environment = std::vector<std::pair<std::string, std::string>>;

// `environment` adds to that of the test. Killed by kMostCpu_s, and, should it sleep for ever, by kMostWall_s.
[[nodiscard]] RunResult run_weft(const std::vector<std::string>& arguments,
                                 const Environment& environment = {},
                                 const std::filesystem::path& folder = {});

// Any program, by its path or its name; the rest as above.
[[nodiscard]] RunResult run_program(const std::vector<std::string>& words,
                                    const Environment& environment = {},
                                    const std::filesystem::path& folder = {});

// An empty folder, removed at the end.
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

// Full matrices, not only the quick ones.
[[nodiscard]] bool extended();

// A Vulkan device is there; otherwise the tests that need one say "skipped".
[[nodiscard]] bool has_device();

}  // namespace weft::test
