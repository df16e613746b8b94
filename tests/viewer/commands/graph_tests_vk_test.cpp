// Tests `weft check --run`, which runs the tests inside graph files: those of the shipped graphs, some that
// must pass, and some that must fail. Also tests debug views.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/viewer/pictures/pfm_image.h"
#include "tests/viewer/program.h"

namespace weft::test {
namespace {

const std::filesystem::path kGraphs = WEFT_SOURCE_DIR "/graphs";

class GraphTests : public testing::Test {
 protected:
    void SetUp() override {
        if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    }

    // Checks a graph whose shader fills the red channel of image x with `value`, a GLSL expression. The green
    // and blue channels are 0, alpha is 1. `rest` contains further sections of the graph.
    RunResult check(const std::string& value, const std::string& rest) const {
        folder_.write("value.comp", R"(#version 460
layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba16f) writeonly uniform image2D x;
layout(push_constant) uniform Params { float zero; } params;
void main() { imageStore(x, ivec2(gl_GlobalInvocationID.xy), vec4(params.zero + )" +
                                        value + R"(, 0, 0, 1)); }
)");
        folder_.write("g.json", R"({
  "version": 1, "name": "tested", "imports": { "backbuffer": "output" }, "params": { "zero": 0 },
  "resources": { "x": "rgba16f", "sum": { "format": "rgba16f", "size": "area", "history": 1 } },
  "sizes": { "area": [16, 16] },
  "passes": {
    "make": { "type": "compute", "shader": "value.comp", "out": ["x"] },
    "add":  { "type": "blit", "in": ["x"], "out": ["sum"] },
    "show": { "type": "blit", "in": ["sum[-1]"], "out": ["backbuffer"] }
  },
  )" + rest + "\n}\n");
        return run_weft({"check", folder_ / "g.json", "--run"});
    }

    // Expects that the check fails with this message, at the place that "$$" marks in `rest`. The graph is
    // checked without the mark; `rest` begins in its line 10.
    void expect_failure(const std::string& value, std::string rest, const std::string& message) const {
        const size_t mark = rest.find("$$");
        rest.erase(mark, 2);
        const size_t line_start = rest.rfind('\n', mark);
        const size_t line = 10 + static_cast<size_t>(std::count(
                                     rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(mark), '\n'));
        const size_t column = line_start == std::string::npos ? mark + 3 : mark - line_start;
        const RunResult run = check(value, rest);
        EXPECT_EQ(run.exit_code, 6) << run.text();
        EXPECT_NE(run.err.find(message), std::string::npos) << run.text();
        const std::string place = "g.json:" + std::to_string(line) + ":" + std::to_string(column) + ":";
        EXPECT_NE(run.err.find(place), std::string::npos) << place << run.text();
    }

    ScratchFolder folder_;
};

TEST_F(GraphTests, ShippedGraphsKeepTheirPromises) {
    // The quick run leaves out graphs that share all their modules with one of these.
    const std::set<std::string> quick{"bloom",        "deferred",      "fjord",
                                      "forward_plus", "light_volumes", "reaction_diffusion"};
    std::vector<std::string> arguments{"check"};
    for (const auto& entry : std::filesystem::directory_iterator(kGraphs))
        if (entry.path().extension() == ".json" &&
            (extended() || quick.contains(entry.path().stem().string())))
            arguments.push_back(entry.path().string());
    ASSERT_GE(arguments.size(), extended() ? 10u : 1 + quick.size());
    arguments.emplace_back("--run");
    const RunResult run = run_weft(arguments);
    EXPECT_EQ(run.exit_code, 0) << run.text();
    size_t runs = 0;
    for (size_t at = run.err.find(": test "); at != std::string::npos; at = run.err.find(": test ", at + 1))
        ++runs;
    EXPECT_GE(runs, arguments.size() - 3) << "every graph has a test\n" << run.err;
}

TEST_F(GraphTests, WhatHoldsPasses) {
    const RunResult run = check("0.5", R"("tests": [ { "size": [32, 32], "expect": {
        "validation": 0, "finite": ["x"], "range": { "x": [0, 1] }, "mean": { "x": [0.37, 0.38] },
        "passes": 5, "barriers": 99, "submissions": 1, "transientBytes": 1e6 } } ])");
    EXPECT_EQ(run.exit_code, 0) << run.text();
    EXPECT_NE(run.err.find("test 1: ok"), std::string::npos) << run.text();
}

TEST_F(GraphTests, WhatFailsIsNamedAtItsPlace) {
    expect_failure("1.0 / params.zero",
                   R"("tests": [ { "size": [32, 32], "expect": { "finite": [$$"x"] } } ])",
                   "\"x\" contains inf at (0, 0)");
    expect_failure("0.5", R"("tests": [ { "size": [32, 32], "expect": { "range": { $$"x": [0.75, 1] } } } ])",
                   "\"x\" contains 0.5 at (0, 0)");
    expect_failure("0.5", R"("tests": [ { "size": [32, 32], "expect": { "mean": { $$"x": [0.75, 1] } } } ])",
                   "the mean of \"x\" is 0.375");
    expect_failure("0.5", R"("tests": [ { "size": [32, 32], "expect": { "passes": $$2 } } ])", "3 passes");
    expect_failure("0.5", R"("tests": [ { "size": [32, 32], "expect": { "transientBytes": $$10 } } ])",
                   "bytes of transient memory");
    expect_failure("0.5",
                   R"("tests": [ { "size": [32, 32], "frames": 1, "expect": { "blackFrames": $$0 } } ])",
                   "1 black pictures");
}

TEST_F(GraphTests, TiersAreRunAndSwapped) {
    const RunResult run =
        check("0.5", R"("tiers": { "low": {}, "high": { "patch": { "resources": { "more": "r8" },
        "passes": { "extra": { "type": "clear", "out": ["more"] }, "keep": { "type": "readback", "in": ["more"] } } } } },
      "tests": [ { "tiers": "*", "size": [32, 32], "expect": { "finite": ["x"] } },
                 { "swap": ["low", "high", "low"], "every": 3, "size": [32, 32],
                   "expect": { "kept": ["sum"], "blackFrames": 1, "pipelinesOnFrameThread": 0 } } ])");
    EXPECT_EQ(run.exit_code, 0) << run.text();
    EXPECT_NE(run.err.find("test 1, tier high: ok"), std::string::npos) << run.text();
    EXPECT_NE(run.err.find("test 2, tier low, then other tiers: ok"), std::string::npos) << run.text();
}

TEST_F(GraphTests, AHistoryThatASwapLosesIsSeen) {
    expect_failure("0.5", R"("tiers": { "low": {}, "high": { "patch": { "sizes": { "area": [8, 8] } } } },
      "tests": [ { "swap": ["low", "high"], "every": 2, "size": [32, 32], "expect": { "kept": [$$"sum"] } } ])",
                   "a change of tier loses the content of \"sum\"");
}

TEST_F(GraphTests, AHistoryThatATierDoesNotUseIsLost) {
    expect_failure(
        "0.5",
        R"("tiers": { "low": {}, "high": { "patch": { "passes": { "show": null, "look": { "type": "blit", "in": ["x"], "out": ["backbuffer"] } } } } },
      "tests": [ { "swap": ["low", "high"], "every": 2, "size": [32, 32], "expect": { "kept": [$$"sum"] } } ])",
        "\"sum\" is freed: no pass of the new plan uses it");
}

TEST_F(GraphTests, AResourceWithoutContentBetweenFramesIsNotKept) {
    expect_failure("0.5", R"("tiers": { "low": {} },
      "tests": [ { "swap": ["low", "low"], "every": 2, "size": [32, 32], "expect": { "kept": [$$"x"] } } ])",
                   "\"x\" has no content between two frames");
}

TEST_F(GraphTests, WhatATestNamesMustBeThere) {
    const RunResult run =
        check("0.5", R"("tests": [ { "tiers": ["lwo"], "scene": "atrium", "params": { "p": 1 },
      "expect": { "finite": ["y"], "range": { "x": [1, 0] }, "pases": 3 } } ])");
    EXPECT_EQ(run.exit_code, 3) << run.text();
    for (const char* code : {"W129", "W109", "W120", "W103", "W101"})
        EXPECT_NE(run.err.find(code), std::string::npos) << code << "\n" << run.text();
}

// The number of frames is an expression with a parameter, so `weft` knows its value only when the tests run.
TEST_F(GraphTests, FramesOfAllRunsAreLimited) {
    const RunResult run = check("0.5", R"("frames": "10000 + zero", "tests": [
      { "size": [32, 32], "frames": 2 }, { "size": [32, 32], "params": { "zero": 6383 } } ])");
    EXPECT_EQ(run.exit_code, 3) << run.text();
    EXPECT_NE(run.err.find("g.json:11:42: error[W125]: the tests of the graph render more than 16384 frames"),
              std::string::npos)
        << run.text();
    EXPECT_NE(run.err.find("raise graph.testFrames"), std::string::npos) << run.text();
}

// Tests of debug views, which `weft render --debug VIEW` renders.
class DebugViews : public GraphTests {
 protected:
    RunResult show(const std::string& graph, const std::string& view, const std::string& file) const {
        return run_weft({"render", "builtin:spheres", "--graph", (kGraphs / graph).string(), "--size",
                         "64x36", "--debug", view, "--output", folder_ / file, "--validate", "--frames", "2",
                         "--stats", folder_ / "stats.json"});
    }
};

TEST_F(DebugViews, EveryOneOfTheShippedGraphsShowsSomething) {
    const std::vector<std::pair<std::string, std::string>> views{
        {"deferred.json", "Albedo"},
        {"deferred.json", "Normals"},
        {"deferred.json", "Depth"},
        {"deferred.json", "velocity"},
        {"deferred.json", "lights"},
        {"bloom.json", "bloom.mip(2)"},
        {"dof.json", "soft.layer(1)"},
        {"edges.json", "Ends"},
        {"taa.json", "Last frame"},
        {"reaction_diffusion.json", "Second chemical"},
        {"tiled_deferred.json", "Lights per tile"},
        {"light_volumes.json", "Light of the volumes"}};
    for (const auto& [graph, view] : views) {
        const RunResult run = show(graph, view, "view.png");
        EXPECT_EQ(run.exit_code, 0) << graph << " " << view << "\n" << run.text();
    }
}

TEST_F(DebugViews, ThePictureIsNoneOfTheirBusiness) {
    const auto hash = [&] {
        return nlohmann::json::parse(read_text(folder_ / "stats.json"))
            .at("output_sha256")
            .get<std::string>();
    };
    ASSERT_EQ(show("deferred.json", "Normals", "view.png").exit_code, 0);
    const std::string with = hash();
    ASSERT_EQ(run_weft({"render", "builtin:spheres", "--graph", (kGraphs / "deferred.json").string(),
                        "--size", "64x36", "--output", folder_ / "plain.png", "--validate", "--frames", "2",
                        "--stats", folder_ / "stats.json"})
                  .exit_code,
              0);
    EXPECT_EQ(with, hash());
    EXPECT_NE(read_text(folder_ / "view.png"), read_text(folder_ / "plain.png"));
}

class DebugPictures : public DebugViews {
 protected:
    PfmImage picture(const std::string& graph, const std::string& view) const {
        const RunResult run =
            run_weft({"render", "builtin:cornell", "--graph", (kGraphs / graph).string(), "--camera", "front",
                      "--size", "320x180", "--debug", view, "--output", folder_ / "view.pfm", "--validate"});
        EXPECT_EQ(run.exit_code, 0) << run.text();
        return read_pfm(folder_ / "view.pfm").value_or(PfmImage{});
    }
};

TEST_F(DebugPictures, WhereNothingWasDrawnTheyAllShowTheSameStripes) {
    const PfmImage depth = picture("deferred.json", "Depth");
    ASSERT_EQ(depth.texels.size(), 320u * 180);
    std::set<std::array<float, 3>> stripes;
    for (size_t x = 0; x < 16; ++x) stripes.insert(depth.at(x, 0));
    EXPECT_EQ(stripes.size(), 2u) << "the sky's upper left corner";
    for (const char* view : {"Normals", "orm", "Velocity", "Albedo"}) {
        const PfmImage shown = picture("deferred.json", view);
        ASSERT_EQ(shown.texels.size(), depth.texels.size());
        for (size_t x = 0; x < 16; ++x) EXPECT_EQ(shown.at(x, 0), depth.at(x, 0)) << view << " at " << x;
        EXPECT_EQ(stripes.count(shown.at(160, 150)), 0u) << view << " shows the ground";
    }
    EXPECT_EQ(stripes.count(picture("deferred.json", "hdr").at(0, 0)), 0u) << "the lighting draws the sky";
}

TEST_F(DebugPictures, NumbersAsColoursHaveALegend) {
    // Returns one row of the colour bar. The bar is 120 px wide and 8 px high. It is 10 px away from the left
    // edge and from the bottom edge of the picture.
    const auto bar = [](const PfmImage& shown) {
        std::vector<std::array<float, 3>> colors;
        for (size_t x = 10; x < 130; ++x) colors.push_back(shown.at(x, 180 - 16));
        return colors;
    };
    const auto greys = bar(picture("deferred.json", "Depth"));
    for (size_t i = 0; i < greys.size(); ++i)
        EXPECT_NEAR(greys[i][0], 1 - static_cast<double>(i) / 119, 0.01) << "near to far, light to dark";
    const auto heats = bar(picture("tiled_deferred.json", "Lights per tile"));
    EXPECT_EQ(std::set(heats.begin(), heats.end()).size(), heats.size())
        << "each number has a colour of its own";
    EXPECT_EQ(heats.front()[0], 0);
    EXPECT_EQ(heats.back()[0], 1);
    // Counts the white pixels above the colour bar, where the legend shows its numbers in white. A view that
    // shows plain colours has no legend.
    const auto letters = [](const PfmImage& shown) {
        size_t count = 0;
        for (size_t y = 180 - 25; y < 180 - 20; ++y)
            for (size_t x = 10; x < 130; ++x)
                count += shown.at(x, y) == std::array<float, 3>{1, 1, 1} ? 1u : 0u;
        return count;
    };
    EXPECT_GT(letters(picture("deferred.json", "Depth")), 20u);
    EXPECT_EQ(letters(picture("deferred.json", "Normals")), 0u);
}

TEST_F(DebugViews, UnknownOnesAreGuessedAt) {
    const RunResult run = show("deferred.json", "Normal", "view.png");
    EXPECT_EQ(run.exit_code, 3);
    EXPECT_NE(run.err.find("W103"), std::string::npos) << run.text();
    EXPECT_NE(run.err.find("Normals"), std::string::npos) << run.text();
}

}  // namespace
}  // namespace weft::test
