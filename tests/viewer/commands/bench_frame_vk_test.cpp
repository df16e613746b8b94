// Tests `weft bench frame` on the available Vulkan device.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/viewer/program.h"

namespace weft::test {
namespace {

using Json = nlohmann::json;

TEST(BenchFrame, MeasuresEveryGraphOverEveryNumberOfLights) {
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    const RunResult run =
        run_weft({"bench", "frame", "builtin:spheres", "--graphs", "deferred,tiled_deferred,light_volumes",
                  "--lights", "2,5", "--size", "64x36", "--rounds", "2", "--json"});
    ASSERT_EQ(run.exit_code, 0) << run.text();
    const Json json = Json::parse(run.out);
    ASSERT_EQ(json["results"].size(), 6u);
    EXPECT_GT(json["bytes_per_s"].get<double>(), 1e7);
    EXPECT_GT(json["flops_per_s"].get<double>(), 1e7);
    EXPECT_GT(json["trivial_ms"].get<double>(), 0);
    for (const Json& result : json["results"]) {
        double sum = 0;
        bool has_costs = false;
        for (const Json& pass : result["passes"]) {
            sum += pass["gpu_ms"]["min"].get<double>();
            has_costs |= pass["flops"].is_number();
            EXPECT_GE(pass["limit_ms"].get<double>(), 0.003) << pass;
            if (pass["name"] == "gbuffer" || pass["name"] == "tonemap") {
                EXPECT_TRUE(pass["common"]) << pass;
            }
            if (pass["name"] == "lighting") {
                EXPECT_FALSE(pass["common"]) << pass;
            }
        }
        EXPECT_TRUE(has_costs) << result["graph"];
        EXPECT_LE(sum, result["frame"]["gpu_ms"]["median"].get<double>() + 1e-9) << result["graph"];
    }
}

TEST(BenchFrame, MeasuresTiersOfAGraph) {
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    const RunResult run =
        run_weft({"bench", "frame", "builtin:spheres", "--graphs", "weft:low,reflections:water", "--lights",
                  "2", "--size", "32x18", "--rounds", "1", "--json"});
    ASSERT_EQ(run.exit_code, 0) << run.text();
    const Json json = Json::parse(run.out);
    EXPECT_EQ(json["graphs"], (Json{"weft:low", "reflections:water"}));
    const auto has = [](const Json& result, const char* name) {
        return std::ranges::any_of(result["passes"], [&](const Json& pass) { return pass["name"] == name; });
    };
    EXPECT_TRUE(has(json["results"][0], "low::surfaces")) << run.out;
    EXPECT_TRUE(has(json["results"][1], "lighting")) << run.out;
}

// The environment is filtered only in frames in which all passes run.
TEST(BenchFrame, MeasuresPassesThatRest) {
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    const RunResult run =
        run_weft({"bench", "frame", "builtin:spheres", "--env",
                  WEFT_SOURCE_DIR "/tests/reference/environments/day.hdr", "--graphs", "deferred", "--lights",
                  "1", "--size", "64x36", "--rounds", "3", "--json"});
    ASSERT_EQ(run.exit_code, 0) << run.text();
    const Json json = Json::parse(run.out), &result = json.at("results").at(0);
    size_t filters = 0;
    for (const Json& pass : result.at("passes")) {
        const std::string name = pass.at("name");
        if (name == "gbuffer") {
            EXPECT_TRUE(pass.at("awake_ms").is_null()) << pass;
        }
        if (!name.starts_with("environmentFilter")) continue;
        ++filters;
        EXPECT_EQ(pass.at("gpu_ms").at("p99"), 0) << pass;
        EXPECT_GT(pass.at("awake_ms").at("min"), 0) << pass;
        EXPECT_DOUBLE_EQ(pass.at("over_limit").get<double>(),
                         pass.at("awake_ms").at("median").get<double>() / pass.at("limit_ms").get<double>());
    }
    EXPECT_EQ(filters, 5u);
    EXPECT_GT(result.at("awake_ms").at("min"), 0);
}

TEST(BenchFrame, TellsWhatItCostsToLightAProbe) {
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    const ScratchFolder folder;
    folder.write(
        "eight.json",
        R"json({ "version": 1, "volume": { "origin": [-1, 3, -1], "spacing": 1, "size": [2, 2, 2] } })json");
    const RunResult run =
        run_weft({"bench", "frame", "builtin:spheres", "--graphs", "deferred", "--lights", "2", "--size",
                  "64x36", "--rounds", "1", "--probes", folder / "eight.json", "--json"});
    ASSERT_EQ(run.exit_code, 0) << run.text();
    const Json result = Json::parse(run.out)["results"].at(0);
    std::map<std::string, uint64_t> rounds;
    for (const Json& cost : result["warm_up"]) {
        rounds[cost["pass"]] = cost["rounds"];
        EXPECT_GT(cost["round_ms"].get<double>(), 0) << cost;
    }
    EXPECT_EQ(rounds["probeBake::faces"], 8u) << result["warm_up"];
    EXPECT_EQ(rounds["probeRelight::light"], 4 * 8u) << result["warm_up"];
    // All rounds together are one pass of the frame.
    const auto is_relight = [](const Json& pass) { return pass["name"] == "probeRelight::light"; };
    EXPECT_EQ(std::ranges::count_if(result["passes"], is_relight), 1);
}

TEST(BenchFrame, AGraphThatIsNotThere) {
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    const RunResult run = run_weft({"bench", "frame", "--graphs", "deferrd"});
    EXPECT_EQ(run.exit_code, 3) << run.text();
    EXPECT_NE(run.err.find("deferrd"), std::string::npos) << run.text();
}

}  // namespace
}  // namespace weft::test
