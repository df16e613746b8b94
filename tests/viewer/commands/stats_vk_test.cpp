// Tests some members of the statistics of `weft render --stats`: the tier, the values of each pass, and the
// numbers of barriers and pipelines.
#include <gtest/gtest.h>

#include <map>

#include "tests/viewer/commands/render_stats.h"

namespace weft::test {
namespace {

using Json = nlohmann::json;

Json stats_of(const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"builtin:spheres", "--graph",
                                       WEFT_SOURCE_DIR "/tests/render/reload/live.json", "--size", "16x16"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return render_stats(std::move(arguments));
}

TEST(Stats, NameTheTierThatWasAskedFor) {
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    EXPECT_EQ(stats_of({"--tier", "low"}).at("tier"), "low");
    EXPECT_TRUE(stats_of({}).at("tier").is_null());
}

TEST(Stats, HoldOfAPassWhatIsMeasured) {
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    const Json stats = stats_of({});
    ASSERT_FALSE(stats.at("passes").empty());
    for (const Json& pass : stats.at("passes")) {
        std::vector<std::string> keys;
        for (const auto& item : pass.items()) keys.push_back(item.key());
        EXPECT_EQ(keys, (std::vector<std::string>{"bytes", "flops", "gpu_ms", "name", "queue"}));
    }
}

TEST(Stats, TellWhichPassesRestedAndWhyTheOthersRan) {
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    const Json stats =
        render_stats({"builtin:spheres", "--graph", WEFT_SOURCE_DIR "/tests/render/rest/rest.json", "--size",
                      "16x16", "--frames", "5", "--verify-rest"});
    uint32_t with_rest = 0;
    for (const Json& pass : stats.at("passes")) {
        if (!pass.contains("rested_frames")) continue;
        ++with_rest;
        EXPECT_EQ(pass.at("rested_frames"), 4) << pass.at("name");
        EXPECT_EQ(pass.at("woken_by").size(), 1u) << pass.at("woken_by");
    }
    EXPECT_EQ(with_rest, 6u);
}

TEST(Stats, TellInHowManyFramesAPassWasSwitchedOff) {
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    const Json stats =
        render_stats({"builtin:spheres", "--graph", WEFT_SOURCE_DIR "/tests/render/switches/switches.json",
                      "--size", "16x16", "--frames", "5", "--param", "mistOn=0"});
    std::map<std::string, uint32_t> off;
    for (const Json& pass : stats.at("passes"))
        if (pass.contains("switched_off_frames")) off[pass.at("name")] = pass.at("switched_off_frames");
    EXPECT_EQ(off, (std::map<std::string, uint32_t>{
                       {"draw", 0}, {"mist", 5}, {"more", 0}, {"shine", 0}, {"veil", 5}}));
}

TEST(Stats, TellHowManyDrawsOfAPassAreOutsideOfItsView) {
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    // The camera is beside the spheres and looks away from them.
    const Json stats =
        render_stats({"builtin:spheres", "--graph", WEFT_SOURCE_DIR "/tests/render/rest/rest.json", "--size",
                      "16x16", "--camera", "50,50,50,60,60,60,40"});
    uint64_t left_out = 0;
    for (const Json& pass : stats.at("passes"))
        if (pass.contains("draws_left_out"))
            left_out += pass.at("draws_left_out").at("median").get<uint64_t>();
    EXPECT_GT(left_out, 40u);
}

TEST(Stats, CountBarriersThatAreNeededAndPipelinesThatAreMadeLate) {
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    const Json stats = stats_of({"--frames", "3"});
    const Json& barriers = stats.at("barriers");
    EXPECT_GT(barriers.at("needed"), 0);
    EXPECT_LE(barriers.at("needed"), barriers.at("emitted"));
    EXPECT_EQ(stats.at("pipelines_built_on_frame_thread"), 0);
}

}  // namespace
}  // namespace weft::test
