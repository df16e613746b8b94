// Tests the statistics that `weft bench frame` computes from measured times.
#include "viewer/bench/frame_bench.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace weft::test {
namespace {

using namespace weft::viewer;
using Json = nlohmann::json;

PassResult pass(const std::string& name, const std::string& key, std::vector<double> ms) {
    PassResult result;
    result.name = name;
    result.key = key;
    result.ms = std::move(ms);
    result.bytes = 8'000'000;
    result.flops = 4e6;
    return result;
}

// Returns invented measurements of two graphs in three rounds. The lighting pass of "loop" takes 0.1 ms per
// light. The lighting pass of "lists" takes 2 ms plus 0.01 ms per light. In the second round, lighting takes
// twice as long. Both graphs have the same G-buffer pass, with a median of 5 ms.
FrameBench sample() {
    FrameBench bench;
    bench.scene = "room";
    bench.size = {64, 36, 1};
    bench.rounds = 3;
    bench.graphs = {"loop", "lists"};
    bench.lights = {10, 100};
    bench.yardsticks = {0.5, 8e9, 1e9};
    for (const uint32_t lights : bench.lights)
        for (const bool lists : {false, true}) {
            const double ms = lists ? 2 + 0.01 * lights : 0.1 * lights;
            GraphResult result{lists ? "lists" : "loop", lights, {}, {0.5, 0.25, 1}};
            result.passes = {pass("gbuffer", "g", {5, 6, 4}),
                             pass("lighting", lists ? "tiles" : "all", {ms, ms * 2, ms})};
            bench.results.push_back(result);
        }
    find_common(bench);
    return bench;
}

TEST(FrameBench, SpreadsAreQuantiles) {
    const Spread odd = spread_of({5, 1, 3});
    EXPECT_EQ(odd.min, 1);
    EXPECT_EQ(odd.quarter, 2);
    EXPECT_EQ(odd.median, 3);
    EXPECT_EQ(odd.three_quarters, 4);
    EXPECT_NEAR(odd.p99, 4.96, 1e-12);
    EXPECT_EQ(spread_of({4, 2}).median, 3);
    EXPECT_EQ(spread_of({}).median, 0);
}

TEST(FrameBench, APassTakesItsLongestPart) {
    const Yardsticks yardsticks{1, 1e9, 1e12};
    EXPECT_DOUBLE_EQ(yardsticks.limit_ms(2e6, 1e6), 2);
    EXPECT_DOUBLE_EQ(yardsticks.limit_ms(2e6, 5e9), 5);
    EXPECT_DOUBLE_EQ(yardsticks.limit_ms(10, 10), 0.003);
}

TEST(FrameBench, WhatAllGraphsHaveIsToldApart) {
    const FrameBench bench = sample();
    EXPECT_TRUE(bench.at(0, 0).passes[0].common);
    EXPECT_FALSE(bench.at(0, 0).passes[1].common);
    EXPECT_EQ(bench.at(0, 0).frame_ms(true), (std::vector<double>{6, 8, 5}));
    EXPECT_EQ(bench.at(0, 0).frame_ms(false), (std::vector<double>{1, 2, 1}));
}

TEST(FrameBench, RatiosAreOfTheSameRound) {
    const FrameBench bench = sample();
    EXPECT_EQ(bench.ratio_to_first(1, 0, false), 1);
    EXPECT_NEAR(bench.ratio_to_first(1, 1, false), 0.3, 1e-12);
    EXPECT_EQ(bench.ratio_to_trivial(0, 0, false), 2) << "of 2, 8 and 1";
}

TEST(FrameBench, NothingAgainstNothingIsNoRatio) {
    FrameBench bench = sample();
    for (GraphResult& result : bench.results) result.passes.resize(1);
    find_common(bench);
    EXPECT_TRUE(std::isnan(bench.ratio_to_first(0, 1, false)));
    EXPECT_EQ(bench_text(bench).find("nan"), std::string::npos);
    EXPECT_NE(bench_text(bench).find("      - "), std::string::npos);
    const Json own = Json::parse(bench_json(bench)).at("results").at(1).at("not_common");
    EXPECT_TRUE(own.at("over_first").is_null());
}

TEST(FrameBench, CurvesCrossOnLogarithmicScales) {
    const std::vector<Crossing> crossings = sample().crossings();
    ASSERT_EQ(crossings.size(), 1u);
    EXPECT_EQ(crossings[0].faster, "lists");
    EXPECT_EQ(crossings[0].slower, "loop");
    // The time of "loop" minus that of "lists" is 1 − 2.1 ms at 10 lights and 10 − 3 ms at 100 lights. The
    // crossing is where this difference is 0, if it is linear in the logarithm of the number of lights.
    EXPECT_NEAR(crossings[0].lights, 10 * std::pow(10.0, 1.1 / 8.1), 1e-9);
    EXPECT_EQ(crossings[0].between, (std::array<uint32_t, 2>{10, 100}));
}

TEST(FrameBench, ReportsSayTheSame) {
    const FrameBench bench = sample();
    const std::string text = bench_text(bench);
    EXPECT_NE(
        text.find("lists is faster than loop with more than about 14 lights (measured between 10 and 100)"),
        std::string::npos)
        << text;
    EXPECT_NE(text.find("copying 8.00 GB/s"), std::string::npos) << text;
    const Json json = Json::parse(bench_json(bench));
    EXPECT_EQ(json["results"].size(), 4u);
    EXPECT_EQ(json["results"][3]["graph"], "lists");
    EXPECT_EQ(json["results"][3]["lights"], 100);
    EXPECT_EQ(json["results"][3]["not_common"]["gpu_ms"]["median"], 3);
    EXPECT_EQ(json["results"][0]["passes"][0]["limit_ms"], 4) << "of 4 MFLOP at 1 GFLOP/s";
    EXPECT_EQ(json["results"][0]["passes"][0]["over_trivial"], 10);
    EXPECT_EQ(json["crossings"][0]["faster"], "lists");
    const std::string svg = bench_svg(bench);
    EXPECT_EQ(svg.find("nan"), std::string::npos) << svg;
    EXPECT_NE(svg.find(">lists</text>"), std::string::npos) << svg;
}

// A table takes 3 ms in a frame in which it runs, and nothing in all other frames.
TEST(FrameBench, APassThatRestsIsComparedWithItsBoundInFramesInWhichItRuns) {
    FrameBench bench = sample();
    EXPECT_EQ(bench_text(bench).find("rest"), std::string::npos);
    EXPECT_TRUE(Json::parse(bench_json(bench)).at("results").at(0).at("awake_ms").is_null());
    PassResult table = pass("table", "t", {0, 0, 0});
    table.awake_ms = {3, 2, 4};
    bench.results[0].passes.push_back(table);
    bench.results[0].awake_ms = {9, 10, 9};
    const Json result = Json::parse(bench_json(bench)).at("results").at(0), found = result.at("passes").at(2);
    EXPECT_EQ(found.at("gpu_ms").at("median"), 0);
    EXPECT_EQ(found.at("awake_ms").at("median"), 3);
    EXPECT_EQ(found.at("over_limit"), 0.75) << "3 ms, and a bound of 4 ms";
    EXPECT_TRUE(result.at("passes").at(0).at("awake_ms").is_null());
    EXPECT_EQ(result.at("frame").at("gpu_ms").at("median"), 6);
    EXPECT_EQ(result.at("awake_ms").at("median"), 9);
    const std::string text = bench_text(bench);
    EXPECT_NE(text.find("    10  loop                 6.00     9.00\n"), std::string::npos) << text;
    EXPECT_NE(text.find("  rests\n"), std::string::npos) << text;
}

}  // namespace
}  // namespace weft::test
