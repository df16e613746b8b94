// Tests that a command always gives the same picture, bit for bit: in each run, for different numbers of
// driver threads, and with random lights of the same seed.
#include <gtest/gtest.h>

#include <set>

#include "tests/viewer/commands/render_stats.h"

namespace weft::test {
namespace {

TEST(Determinism, OneHashForEveryRunAndThreadCount) {
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    const ScratchFolder folder;
    const int runs = extended() ? 5 : 1;
    std::set<std::string> hashes;
    for (const char* threads : {"0", "1", "2"}) {
        for (int i = 0; i < runs; ++i) {
            const RunResult run = run_weft({"render", "builtin:atrium", "--size", "320x180", "--frames", "4",
                                            "-o", folder / "a.png", "--stats", folder / "stats.json"},
                                           {{"LP_NUM_THREADS", threads}});
            ASSERT_EQ(run.exit_code, 0) << run.text();
            const auto stats = nlohmann::json::parse(read_text(folder / "stats.json"));
            hashes.insert(stats.at("output_sha256"));
            EXPECT_EQ(stats.at("frames"), 4);
        }
    }
    ASSERT_EQ(hashes.size(), 1u);
    EXPECT_EQ(hashes.begin()->size(), 64u);
    RecordProperty("output_sha256", *hashes.begin());
}

std::string picture_of(const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"builtin:mirror", "--graph", WEFT_SOURCE_DIR "/graphs/forward.json",
                                       "--size", "64x36"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return render_stats(std::move(arguments)).value("output_sha256", std::string());
}

TEST(Determinism, SeededLightsAreTheSameForTheSameSeed) {
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    const std::string one = picture_of({"--lights", "64", "--seed", "7"});
    EXPECT_EQ(picture_of({"--lights", "64", "--seed", "7"}), one);
    EXPECT_NE(picture_of({"--lights", "64", "--seed", "8"}), one);
    EXPECT_NE(picture_of({"--lights", "65", "--seed", "7"}), one);
    for (const char* count : {"0", "-1", "65537", "many"})
        EXPECT_EQ(run_weft({"render", "--lights", count}).exit_code, 2) << count;
}

}  // namespace
}  // namespace weft::test
