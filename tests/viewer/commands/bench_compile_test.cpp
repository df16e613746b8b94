// Tests the text and the JSON of `weft bench compile`.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/viewer/program.h"

namespace weft::test {
namespace {

using Json = nlohmann::json;

TEST(BenchCompile, CompilesGraphsOfChanceAndSaysWhereTheTimeGoes) {
    const RunResult text = run_weft({"bench", "compile", "--passes", "50", "--shape", "chain"});
    EXPECT_EQ(text.exit_code, 0) << text.text();
    for (const char* part :
         {"50 passes, chain, 1 queue, 30 graphs: seeds 1 to 30", "schedule", "alias", "barriers",
          "heap / peak ", "program 30 times", "front end ", "resolve ", "check  ", "unchanged  ", "value  "})
        EXPECT_NE(text.out.find(part), std::string::npos) << text.text();
    const RunResult one = run_weft({"bench", "compile", "--passes", "50", "--seeds", "1"});
    for (const char* part : {"50 passes, random, 1 queue, seed 1", "<- chosen", "all resources"})
        EXPECT_NE(one.out.find(part), std::string::npos) << one.text();
}

TEST(BenchCompile, ReportsEachGraphAndTheWorstOfThemAsJson) {
    const RunResult run = run_weft(
        {"bench", "compile", "--passes", "50", "--seed", "7", "--seeds", "3", "--queues", "2", "--json"});
    EXPECT_EQ(run.exit_code, 0) << run.text();
    const Json json = Json::parse(run.out);
    EXPECT_EQ(json.at("queues"), 2);
    ASSERT_EQ(json.at("graphs").size(), 3u);
    double worst_us = 0, worst_heap = 0;
    for (size_t i = 0; i < 3; ++i) {
        const Json& graph = json.at("graphs")[i];
        EXPECT_EQ(graph.at("seed"), 7 + i);
        EXPECT_LE(graph.at("warm_us").at("min"), graph.at("warm_us").at("median"));
        EXPECT_EQ(graph.at("candidates").size(), 3u);
        EXPECT_GT(graph.at("barriers"), 0);
        worst_us = std::max(worst_us, graph.at("warm_us").at("min").get<double>());
        worst_heap = std::max(
            worst_heap, graph.at("heap_bytes").get<double>() / graph.at("peak_live_bytes").get<double>());
    }
    EXPECT_DOUBLE_EQ(json.at("us").at("worst"), worst_us);
    EXPECT_LE(json.at("us").at("median"), json.at("us").at("worst"));
    EXPECT_DOUBLE_EQ(json.at("heap_to_peak").at("worst"), worst_heap);
    EXPECT_TRUE(json.at("stages_us").at("alias").contains("worst"));
    EXPECT_TRUE(json.at("front_end_stages_us").at("resolve").contains("worst"));
    EXPECT_GT(json.at("unchanged_us"), 0);
    EXPECT_GT(json.at("value_us"), 0);
    double worst_check_us = 0;
    for (const Json& graph : json.at("graphs")) {
        EXPECT_GT(graph.at("front_end_us").at("read"), 0);
        worst_check_us = std::max(worst_check_us, graph.at("check_us").get<double>());
    }
    EXPECT_DOUBLE_EQ(json.at("check_us").at("worst"), worst_check_us);
}

}  // namespace
}  // namespace weft::test
