// Tests the options --probes and --probe-rounds of `weft render`, and the statistics about probes.
#include <gtest/gtest.h>

#include "tests/viewer/commands/render_stats.h"

namespace weft::test {
namespace {

using Json = nlohmann::json;

constexpr const char* kFacesGraph = WEFT_SOURCE_DIR "/tests/render/probes/faces.json";
constexpr const char* kTwelveProbes =
    R"json({ "version": 1, "volume": { "origin": [-1, 3, -1], "spacing": 1, "size": [3, 2, 2] } })json";

Json stats_with(const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"builtin:spheres", "--graph",  kFacesGraph, "--size",
                                       "96x32",           "--frames", "3"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return render_stats(std::move(arguments));
}

TEST(RenderProbes, AreLitBeforeTheFirstFrame) {
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    const ScratchFolder folder;
    folder.write("twelve.json", kTwelveProbes);
    const Json stats = stats_with({"--probes", folder / "twelve.json", "--probe-rounds", "2"});
    const Json& probes = stats.at("probes");
    EXPECT_EQ(probes.at("irradiance"), 12);
    EXPECT_EQ(probes.at("warm_up").at("frames"), 2);
    // The group rests, so each probe is drawn once.
    EXPECT_EQ(probes.at("warm_up").at("groups").at(0).at("name"), "bake");
    EXPECT_EQ(probes.at("warm_up").at("groups").at(0).at("rounds_run"), 12);
    EXPECT_EQ(stats.at("groups").at(0).at("rounds"), 12);
    EXPECT_EQ(stats.at("groups").at(0).at("rounds_run").at("p99"), 0);
}

TEST(RenderProbes, HaveTurnsIfThereAreNoRoundsBefore) {
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    const ScratchFolder folder;
    folder.write("twelve.json", kTwelveProbes);
    const Json stats = stats_with({"--probes", folder / "twelve.json", "--probe-rounds", "0"});
    EXPECT_EQ(stats.at("probes").at("warm_up").at("frames"), 0);
    EXPECT_EQ(stats.at("groups").at(0).at("rounds_run").at("min"), 4);
    EXPECT_EQ(stats.at("groups").at(0).at("rounds_run").at("p99"), 4);
}

TEST(RenderProbes, OfTheSceneAreCountedOnce) {
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    EXPECT_GT(stats_with({"--probes", "auto", "--probe-rounds", "1"}).at("probes").at("irradiance"), 8);
    EXPECT_TRUE(stats_with({"--probes", "none"}).at("probes").is_null());
}

TEST(RenderProbes, AFileThatIsNotThere) {
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    const RunResult run = run_weft(
        {"render", "builtin:spheres", "--graph", kFacesGraph, "--size", "96x32", "--probes", "missing.json"});
    EXPECT_EQ(run.exit_code, 3) << run.text();
    EXPECT_NE(run.err.find("missing.json"), std::string::npos) << run.text();
}

}  // namespace
}  // namespace weft::test
