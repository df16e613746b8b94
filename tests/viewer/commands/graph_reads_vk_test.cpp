// Tests that `weft render` reads its graph file, and each included file, exactly once.
#include <gtest/gtest.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <filesystem>

#include "tests/viewer/program.h"

namespace weft::test {
namespace {

namespace fs = std::filesystem;

// Counts how often each watched file is opened, beginning with the call of watch().
class OpenCounter {
 public:
    OpenCounter() : events_(inotify_init1(IN_CLOEXEC | IN_NONBLOCK)) {}
    ~OpenCounter() { close(events_); }
    OpenCounter(const OpenCounter&) = delete;
    OpenCounter& operator=(const OpenCounter&) = delete;

    void watch(const std::string& file) {
        // With IN_OPEN alone, the kernel would merge two successive opens of a file into one event. The
        // close event between them prevents this.
        const int id = inotify_add_watch(events_, file.c_str(), IN_OPEN | IN_CLOSE);
        ASSERT_GE(id, 0) << file;
        files_[id] = file;
    }
    [[nodiscard]] std::map<std::string, int> counts() {
        std::map<std::string, int> counts;
        for (const auto& [id, file] : files_) counts[file] = 0;
        inotify_event event{};
        while (read(events_, &event, sizeof event) == static_cast<ssize_t>(sizeof event))
            counts[files_[event.wd]] += (event.mask & IN_OPEN) != 0 ? 1 : 0;
        return counts;
    }

 private:
    int events_;
    std::map<int, std::string> files_;
};

TEST(GraphReads, RenderReadsEachGraphFileOnce) {
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    const ScratchFolder folder;
    fs::copy(WEFT_SOURCE_DIR "/graphs", folder.path(), fs::copy_options::recursive);
    const std::string graph = folder / "deferred.json";
    OpenCounter opened;
    opened.watch(graph);
    // The graph file includes this module.
    opened.watch(folder / "modules/sun_shadows.json");
    const RunResult run = run_weft(
        {"render", "builtin:spheres", "--graph", graph, "--size", "32x18", "-o", folder / "frame.png"});
    ASSERT_EQ(run.exit_code, 0) << run.text();
    for (const auto& [file, count] : opened.counts()) EXPECT_EQ(count, 1) << file;
}

}  // namespace
}  // namespace weft::test
