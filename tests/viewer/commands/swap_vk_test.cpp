// Tests `weft render --swap`: the graphs follow each other at fixed frames, and a graph with errors leaves
// the running one.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/viewer/program.h"

namespace weft::test {
namespace {

using Json = nlohmann::json;

// The brightness of the picture tells which tier drew it.
constexpr const char* kSwapGraph = R"({
  "version": 1, "name": "g", "imports": { "backbuffer": "output" }, "params": { "grey": { "default": 0.25, "range": [0, 1] } },
  "resources": { "flat": "rgba8" },
  "passes": { "fill": { "type": "clear", "out": ["flat"], "clear": ["grey", "grey", "grey", 1] },
              "show": { "type": "blit", "in": ["flat"], "out": ["backbuffer"] } },
  "tiers": { "low": { "set": { "grey": 0.5 } }, "high": { "set": { "grey": 0.75 } },
             "wrong": { "patch": { "passes": { "show": { "in": ["fault"] } } } } }
})";

class Swap : public ::testing::Test {
 protected:
    void SetUp() override {
        if (!has_device()) GTEST_SKIP() << "no Vulkan device";
        folder_.write("g.json", kSwapGraph);
        folder_.write("other.json",
                      R"({ "version": 1, "include": ["g.json"], "params": { "grey": { "default": 1 } } })");
    }
    RunResult render(const std::string& graphs, const std::vector<std::string>& options) {
        std::vector<std::string> words{"render",  "builtin:spheres", "--graph",   "g.json", "--size",  "8x8",
                                       "-o",      "x.png",           "--swap",    graphs,   "--every", "2",
                                       "--stats", "s.json",          "--validate"};
        words.insert(words.end(), options.begin(), options.end());
        return run_weft(words, {}, folder_.path());
    }
    Json stats() { return Json::parse(read_text(folder_ / "s.json")); }
    // Renders frames of the graph alone, for comparison.
    std::string picture_of(const std::string& graph, const std::string& tier) {
        std::vector<std::string> words{"render", "builtin:spheres", "--graph", graph, "--size", "8x8",
                                       "-o",     "alone.png"};
        if (!tier.empty()) words.insert(words.end(), {"--tier", tier});
        EXPECT_EQ(run_weft(words, {}, folder_.path()).exit_code, 0);
        return read_text(folder_ / "alone.png");
    }

    ScratchFolder folder_;
};

TEST_F(Swap, GraphsFollowEachOtherAtFixedFrames) {
    const RunResult run = render("low,high,other.json", {"--frames", "7"});
    ASSERT_EQ(run.exit_code, 0) << run.text();
    const Json swaps = stats().at("swaps");
    ASSERT_EQ(swaps.size(), 3u);
    for (size_t i = 0; i < swaps.size(); ++i) EXPECT_EQ(swaps[i].at("frame"), 3 + 2 * i);
    EXPECT_EQ(swaps[0].at("to"), "high");
    EXPECT_EQ(swaps[2].at("to"), "low");
    EXPECT_EQ(stats().at("tier"), "low");
    EXPECT_EQ(stats().at("pipelines_built_on_frame_thread"), 0);
    EXPECT_EQ(read_text(folder_ / "x.png"), picture_of("g.json", "low"));
    ASSERT_EQ(render("low,high,other.json", {"--frames", "5"}).exit_code, 0);
    EXPECT_EQ(read_text(folder_ / "x.png"), picture_of("other.json", ""));
    ASSERT_EQ(render("low,other.json:high", {"--frames", "3"}).exit_code, 0);
    EXPECT_EQ(read_text(folder_ / "x.png"), picture_of("g.json", "high"));
}

TEST_F(Swap, AGraphWithErrorsLeavesTheRunningOne) {
    const RunResult run = render("low,wrong", {"--frames", "3"});
    EXPECT_EQ(run.exit_code, 3) << run.text();
    EXPECT_NE(run.err.find("W103"), std::string::npos) << run.text();
    EXPECT_EQ(stats().at("swaps")[0].at("failed"), true);
    EXPECT_EQ(read_text(folder_ / "x.png"), picture_of("g.json", "low"));
}

TEST_F(Swap, TheStartNeedsAGoodGraph) {
    EXPECT_EQ(render("wrong,low", {}).exit_code, 3);
    EXPECT_EQ(render("low,high", {"--tier", "low"}).exit_code, 2);
}

}  // namespace
}  // namespace weft::test
