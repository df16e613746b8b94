// Runs the examples of the pages in docs/: writes their files to a folder and runs them with the built
// program. No C++ code is compiled, only shaders.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/viewer/documentation/snippets.h"
#include "tests/viewer/gltf_file.h"
#include "tests/viewer/pictures/pfm_image.h"
#include "tests/viewer/program.h"

namespace weft::test {
namespace {

using Json = nlohmann::json;
constexpr const char* kPassPage = "writing-a-pass.md";
constexpr double kStrength = 0.9;

// Largest difference caused by two roundings to 8 bits: when pass "tonemap" stores `display`, and when pass
// "vignette" stores the output. Each rounding changes a value by at most half a step of 1/255.
constexpr double kTwoRoundings = 1.01 / 255;

void write_snippets(const std::string& page, const ScratchFolder& folder) {
    const auto snippets = snippets_of(page);
    ASSERT_FALSE(snippets.empty()) << page;
    for (const auto& [name, content] : snippets) folder.write(name, content);
}

// Renders in `folder` as the commands of the page do. The width and the height in pixels are odd numbers.
RunResult render(const ScratchFolder& folder, const std::string& graph, std::vector<std::string> more) {
    std::vector<std::string> arguments{"render", "builtin:spheres", "--graph",   graph,
                                       "--size", "61x43",           "--validate"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_weft(arguments, {}, folder.path());
}

double vignette(uint32_t x, uint32_t y, const PfmImage& image) {
    const double u = (x + 0.5) / image.width_px - 0.5, v = (y + 0.5) / image.height_px - 0.5;
    return 1.0 - kStrength * 2.0 * (u * u + v * v);
}

void expect_vignette(const PfmImage& display, const PfmImage& output) {
    ASSERT_EQ(output.texels.size(), display.texels.size());
    double worst = 0, brightest = 0;
    for (uint32_t y = 0; y < output.height_px; ++y) {
        for (uint32_t x = 0; x < output.width_px; ++x) {
            for (size_t c = 0; c < 3; ++c) {
                const double wanted = display.at(x, y)[c] * vignette(x, y, output);
                worst = std::max(worst, std::abs(output.at(x, y)[c] - wanted));
                brightest = std::max(brightest, wanted);
            }
        }
    }
    EXPECT_LE(worst, kTwoRoundings);
    EXPECT_GT(brightest, 0.2) << "a black picture proves nothing";
}

class FullscreenEffect : public testing::Test {
 protected:
    void SetUp() override {
        if (!has_device()) GTEST_SKIP() << "no Vulkan device";
        write_snippets(kPassPage, folder_);
    }

    void expect_effect(const std::string& graph) {
        const RunResult check = run_weft({"check", graph}, {}, folder_.path());
        ASSERT_EQ(check.exit_code, 0) << check.text();
        const RunResult output = render(folder_, graph, {"--param", "strength=0.9", "-o", "output.pfm"});
        ASSERT_EQ(output.exit_code, 0) << output.text();
        const RunResult before =
            render(folder_, graph, {"--param", "strength=0.9", "--resource", "display", "-o", "display.pfm"});
        ASSERT_EQ(before.exit_code, 0) << before.text();
        const auto display = read_pfm(folder_ / "display.pfm"), after = read_pfm(folder_ / "output.pfm");
        ASSERT_TRUE(display && after);
        expect_vignette(*display, *after);
    }

    ScratchFolder folder_;
};

TEST_F(FullscreenEffect, OfThePageDarkensTheCorners) {
    expect_effect("vignette.json");
}

TEST_F(FullscreenEffect, DoesTheSameAsAComputePass) {
    const std::string graph = read_text(folder_ / "vignette.json");
    folder_.write("compute.json", replaced(graph, R"("type": "fullscreen", "shader": "vignette.frag")",
                                           R"("type": "compute", "shader": "vignette.comp")"));
    expect_effect("compute.json");
}

TEST(Documentation, TheGraphPageRuns) {
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    const ScratchFolder folder;
    write_snippets("format.md", folder);
    const RunResult run = render(folder, "fog.json", {"-o", "fog.pfm"});
    ASSERT_EQ(run.exit_code, 0) << run.text();
    const auto fog = read_pfm(folder / "fog.pfm");
    ASSERT_TRUE(fog);
    float nearest = 1, farthest = 0;
    for (const auto& texel : fog->texels) {
        nearest = std::min(nearest, texel[0]);
        farthest = std::max(farthest, texel[0]);
    }
    EXPECT_GT(nearest, 0.1f);
    EXPECT_GT(farthest, nearest + 0.1f) << "what is farther lies in thicker fog";
    EXPECT_LE(farthest, 1.0f);
}

// The example project has its own folders for graphs and shaders, and a script for continuous integration.
TEST(Documentation, TheProjectPageRuns) {
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    const ScratchFolder folder;
    write_snippets("projects.md", folder);
    const Environment path{
        {"PATH", std::filesystem::path(WEFT_PROGRAM).parent_path().string() + ":/usr/bin:/bin"}};
    const auto sh = [&](const std::string& command) {
        return run_program({"sh", "-c", command}, path, folder.path());
    };
    const RunResult check = sh("weft check pipelines/*.json");
    ASSERT_EQ(check.exit_code, 0) << check.text();
    const RunResult golden =
        sh("mkdir golden && weft render builtin:cornell --graph pipelines/night.json "
           "--size 320x180 --probes none -o golden/night.png");
    ASSERT_EQ(golden.exit_code, 0) << golden.text();
    const RunResult good = sh("sh ci/pipelines.sh");
    EXPECT_EQ(good.exit_code, 0) << good.text();
    const std::string graph = read_text(folder / "pipelines/night.json");
    folder.write("pipelines/night.json", replaced(graph, "\"default\": -2", "\"default\": 0"));
    EXPECT_EQ(sh("sh ci/pipelines.sh").exit_code, 6) << "another picture";
    folder.write("pipelines/night.json", replaced(graph, "grade.json", "grede.json"));
    EXPECT_EQ(sh("sh ci/pipelines.sh").exit_code, 3) << "an include that is not there";
    const Json log = Json::parse(read_text(folder / "weft.sarif"));
    EXPECT_FALSE(log.at("runs").at(0).at("results").empty()) << "what CI uploads names it";
}

TEST(Documentation, TheExampleGraphRunsAndObservingItChangesNothing) {
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    const ScratchFolder folder;
    const std::string graph = WEFT_SOURCE_DIR "/docs/examples/ink.json";
    const RunResult plain = render(folder, graph, {"-o", "ink.pfm", "--stats", "plain.json"});
    ASSERT_EQ(plain.exit_code, 0) << plain.text();
    const RunResult observed =
        render(folder, graph, {"-o", "lines.pfm", "--resource", "lines", "--stats", "observed.json"});
    ASSERT_EQ(observed.exit_code, 0) << observed.text();
    const Json a = Json::parse(read_text(folder / "plain.json")),
               b = Json::parse(read_text(folder / "observed.json"));
    EXPECT_EQ(a.at("output_sha256"), b.at("output_sha256"));
    const auto ink = read_pfm(folder / "ink.pfm");
    ASSERT_TRUE(ink);
    size_t paper = 0, dark = 0;
    for (const auto& texel : ink->texels) {
        paper += texel[0] > 0.9f;
        dark += texel[0] < 0.4f;
    }
    EXPECT_GT(paper, ink->texels.size() / 10);
    EXPECT_GT(dark, ink->texels.size() / 200);
}

}  // namespace
}  // namespace weft::test
