// Edits files and reverts the edits for ten minutes while `weft view --headless` runs. After the first
// minute, the driver must compile no more machine code, and the memory must grow by at most 1 MiB.
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <cstring>
#include <filesystem>
#include <map>
#include <optional>
#include <sstream>

#include "tests/render/code_counter/code_counter.h"
#include "tests/viewer/program.h"
#include "tests/viewer/running_program.h"

namespace weft::test {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr auto kFirst = std::chrono::minutes(1), kAll = std::chrono::minutes(10);
// Limit of processor time, in seconds. The program renders without a pause, on all cores.
constexpr unsigned kMostSoakCpu_s = 36000;
constexpr int64_t kMiB = 1 << 20;

class ViewSoak : public ::testing::Test {
 protected:
    void SetUp() override {
        if (!extended()) GTEST_SKIP() << "only with WEFT_EXTENDED";
        if (!has_device()) GTEST_SKIP() << "no Vulkan device";
        for (const auto& entry : fs::directory_iterator(WEFT_SOURCE_DIR "/tests/render/reload"))
            fs::copy(entry.path(), folder_.path());
        program_.emplace(
            std::vector<std::string>{"view", "builtin:spheres", "--graph", folder_ / "live.json", "--size",
                                     "64x36", "--headless"},
            Environment{{"LD_PRELOAD", WEFT_CODE_COUNTER}, {kCodeCountVariable, folder_ / "count"}},
            kMostSoakCpu_s);
        ASSERT_TRUE(program_->says("weft: watching")) << program_->err();
    }
    // Changes a file as most editors do: writes a new file and renames it over the old one.
    void replace(const std::string& name, const std::string& from, const std::string& to) const {
        std::string text = read_text(folder_ / name);
        const size_t at = text.find(from);
        ASSERT_NE(at, std::string::npos) << name << " has no " << from;
        folder_.write(name + "~", text.replace(at, from.size(), to));
        fs::rename(folder_ / (name + "~"), folder_ / name);
    }
    // Returns how many pieces of machine code the driver has compiled. The preloaded library code_counter
    // writes this number to the file "count".
    [[nodiscard]] uint64_t compiled() const {
        const std::string bytes = read_text(folder_ / "count");
        uint64_t count = 0;
        if (bytes.size() == sizeof count) std::memcpy(&count, bytes.data(), sizeof count);
        return count;
    }
    [[nodiscard]] int64_t resident() const {
        std::istringstream numbers(read_text("/proc/" + std::to_string(program_->id()) + "/statm"));
        int64_t pages = 0, resident = 0;
        numbers >> pages >> resident;
        return resident * sysconf(_SC_PAGESIZE);
    }
    // Makes three edits and reverts each of them: another parameter value, another size in the graph, and an
    // error in a shader.
    void edit_all() {
        edit("live.json", "\"default\": 0.5", "\"default\": 0.8", " ms: new values");
        edit("live.json", "\"default\": 0.8", "\"default\": 0.5", " ms: new values");
        edit("live.json", "[40, 24]", "[56, 16]", "a new plan");
        edit("live.json", "[56, 16]", "[40, 24]", "a new plan");
        edit("paint.comp", "imageStore", "imageStor", "the last valid graph continues to run");
        replace("paint.comp", "imageStor(", "imageStore(");
    }
    void edit(const std::string& file, const std::string& from, const std::string& to,
              const std::string& said) {
        ASSERT_NO_FATAL_FAILURE(replace(file, from, to));
        ASSERT_TRUE(program_->says(said, ++said_[said])) << program_->err();
    }

    ScratchFolder folder_;
    std::optional<RunningProgram> program_;
    std::map<std::string, int> said_;
};

TEST_F(ViewSoak, CompilesNothingAndKeepsItsMemory) {
    const Clock::time_point begin = Clock::now();
    int64_t early = 0;
    uint64_t compiled_early = 0;
    int rounds = 0;
    while (Clock::now() - begin < kAll) {
        ASSERT_NO_FATAL_FAILURE(edit_all());
        ++rounds;
        if (early != 0 || Clock::now() - begin < kFirst) continue;
        early = resident();
        compiled_early = compiled();
        ASSERT_GT(compiled_early, 0u) << "nothing is counted";
    }
    const int64_t late = resident();
    std::printf("%d rounds of edits: resident KiB %lld after a minute and %lld at last\n", rounds,
                static_cast<long long>(early / 1024), static_cast<long long>(late / 1024));
    EXPECT_EQ(compiled(), compiled_early);
    EXPECT_LE(late - early, kMiB);
    program_->close_stdin();
    EXPECT_EQ(program_->exit_code(), 0) << program_->err();
}

}  // namespace
}  // namespace weft::test
