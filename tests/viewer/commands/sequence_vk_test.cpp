// Tests `weft render --frames A..B` and `--camera-path`: each picture of a sequence is the picture that a
// shorter run writes, also in the sandbox, and the camera follows its path.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/viewer/commands/render_stats.h"

namespace weft::test {
namespace {

// The camera moves for half a second. Then it jumps to another place.
constexpr const char* kWalk = R"({ "version": 1, "keys": [
    { "time": 0, "eye": [0, 1.5, 6], "at": [0, 1, 0], "fovY": 45 },
    { "time": 0.5, "eye": [3, 1.5, 5], "at": [0, 1, 0] },
    { "time": 1, "eye": [-4, 3, 4], "at": [0, 1, 0], "cut": true } ] })";

class Sequence : public testing::Test {
 protected:
    void SetUp() override {
        if (!has_device()) GTEST_SKIP() << "no Vulkan device";
        std::ofstream(walk()) << kWalk;
    }

    [[nodiscard]] std::string walk() const { return folder_ / "walk.json"; }

    // Renders frames of a graph with history. Returns the bytes of the file with the number `picture`.
    std::string render(const std::string& frames, const std::string& output, const std::string& picture,
                       const std::vector<std::string>& more) const {
        std::vector<std::string> arguments{"render",     "builtin:spheres",
                                           "--graph",    WEFT_SOURCE_DIR "/graphs/taa.json",
                                           "--size",     "48x27",
                                           "--probes",   "none",
                                           "--fixed-dt", "1/4",
                                           "--frames",   frames,
                                           "-o",         folder_ / output};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const RunResult run = run_weft(arguments);
        EXPECT_EQ(run.exit_code, 0) << run.text();
        std::ifstream file(folder_ / picture, std::ios::binary);
        EXPECT_TRUE(file.good()) << picture;
        return {std::istreambuf_iterator<char>(file), {}};
    }

    ScratchFolder folder_;
};

TEST_F(Sequence, HasThePicturesOfShorterRuns) {
    const std::vector<std::string> path{"--camera-path", walk()};
    const std::string first = render("2..5", "s%02d.png", "s02.png", path);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "s01.png"));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "s06.png"));
    for (const int frame : {2, 3, 5}) {
        const std::string number = std::to_string(frame);
        std::ifstream file(folder_ / ("s0" + number + ".png"), std::ios::binary);
        const std::string picture{std::istreambuf_iterator<char>(file), {}};
        EXPECT_EQ(picture, render(number, "one.png", "one.png", path)) << number;
    }
    EXPECT_NE(first, render("3", "one.png", "one.png", path)) << "the camera moves";
}

TEST_F(Sequence, InTheSandboxIsTheSame) {
    const std::string outside = render("1..2", "a%d.png", "a2.png", {"--camera-path", walk()});
    const std::string inside = render("1..2", "b%d.png", "b2.png", {"--camera-path", walk(), "--sandbox"});
    EXPECT_EQ(outside, inside);
    EXPECT_TRUE(std::filesystem::exists(folder_ / "b1.png"));
}

// After the cut, shaders see no motion: the velocities are those of a first frame at the same place.
TEST_F(Sequence, ACutStartsWithoutHistory) {
    const auto velocity = [&](const std::string& frames, const std::vector<std::string>& camera) {
        std::vector<std::string> more{"--resource", "velocity"};
        more.insert(more.end(), camera.begin(), camera.end());
        return render(frames, "velocity.pfm", "velocity.pfm", more);
    };
    const std::string still = velocity("1", {"--camera", "-4,3,4,0,1,0,45"});
    EXPECT_EQ(velocity("5", {"--camera-path", walk()}), still);
    EXPECT_NE(velocity("2", {"--camera-path", walk()}), still) << "between the first keys, the camera moves";
}

TEST_F(Sequence, BadUsesAreNamed) {
    const auto fails = [&](const std::vector<std::string>& more, const char* words, int code) {
        std::vector<std::string> arguments{"render", "builtin:spheres", "-o", folder_ / "seq.png"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const RunResult run = run_weft(arguments);
        EXPECT_EQ(run.exit_code, code) << run.text();
        EXPECT_NE(run.err.find(words), std::string::npos) << run.text();
    };
    fails({"--frames", "1..3"}, "seq%04d.png", 2);
    fails({"--frames", "3..1"}, "the range of frames \"3..1\" is empty", 2);
    fails({"--frames", "0..1"}, "--frames", 2);
    fails({"--frames", "1..x"}, "--frames", 2);
    fails({"--camera-path", folder_ / "none.json"}, "none.json", 3);
    fails({"--camera-path", walk(), "--camera", "overview"}, "excludes", 2);
}

}  // namespace
}  // namespace weft::test
