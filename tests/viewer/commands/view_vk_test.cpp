// Tests `weft view --headless` as a person or a script uses it: files change while the program renders.
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/viewer/program.h"
#include "tests/viewer/running_program.h"

namespace weft::test {
namespace {

namespace fs = std::filesystem;

class View : public ::testing::Test {
 protected:
    void SetUp() override {
        if (!has_device()) GTEST_SKIP() << "no Vulkan device";
        for (const auto& entry : fs::directory_iterator(WEFT_SOURCE_DIR "/tests/render/reload"))
            fs::copy(entry.path(), folder_.path());
    }
    [[nodiscard]] std::vector<std::string> arguments(std::vector<std::string> more = {}) const {
        std::vector<std::string> all{"view",   "builtin:spheres", "--graph",   folder_ / "live.json",
                                     "--size", "64x36",           "--headless"};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    [[nodiscard]] nlohmann::json stats() const {
        return nlohmann::json::parse(read_text(folder_ / "stats.json"));
    }
    // Saves a file as most editors do: writes a new file and renames it over the old one.
    void save(const std::string& name, const std::string& text) const {
        folder_.write(name + "~", text);
        fs::rename(folder_ / (name + "~"), folder_ / name);
    }
    void replace(const std::string& name, const std::string& from, const std::string& to) const {
        std::string text = read_text(folder_ / name);
        const size_t at = text.find(from);
        ASSERT_NE(at, std::string::npos);
        save(name, text.replace(at, from.size(), to));
    }

    ScratchFolder folder_;
};

TEST_F(View, FollowsEditsUntilStdinCloses) {
    RunningProgram program(
        arguments({"--validate", "--output", folder_ / "last.png", "--stats", folder_ / "stats.json"}));
    ASSERT_TRUE(program.says("weft: watching")) << program.err();
    replace("tint.glsl", "0.75", "0.25");
    ASSERT_TRUE(program.says(" ms: 1 of 4 shaders, 1 of 3 pipelines")) << program.err();

    const std::string good = read_text(folder_ / "paint.comp");
    replace("paint.comp", "imageStore", "imageStor");
    ASSERT_TRUE(program.says("the last valid graph continues to run")) << program.err();
    EXPECT_TRUE(program.says("paint.comp:10:")) << program.err();
    EXPECT_TRUE(program.says("error[W202]")) << program.err();
    replace("live.json", "\"default\": 0.5", "\"default\": 0.8");
    ASSERT_TRUE(program.says("the last valid graph continues to run", 2)) << program.err();
    save("paint.comp", good);
    ASSERT_TRUE(program.says(" ms: new values")) << program.err();

    program.close_stdin();
    EXPECT_EQ(program.exit_code(), 0) << program.err();
    EXPECT_TRUE(program.says("weft: wrote"));
    const nlohmann::json found = stats();
    EXPECT_EQ(found["reloads"], 2);
    EXPECT_EQ(found["failed_reloads"], 2);
    EXPECT_EQ(found["validation"]["messages"], 0);
    EXPECT_EQ(found["pipelines_built_on_frame_thread"], 0);
    EXPECT_GT(found["frames"], 10);

    const RunResult fresh = run_weft({"render", "builtin:spheres", "--graph", folder_ / "live.json", "--size",
                                      "64x36", "--frames", "3", "-o", folder_ / "fresh.png"});
    ASSERT_EQ(fresh.exit_code, 0) << fresh.text();
    EXPECT_EQ(read_text(folder_ / "last.png"), read_text(folder_ / "fresh.png"));
    for (const auto& entry : fs::directory_iterator(folder_.path()))
        EXPECT_EQ(entry.path().string().find(".part"), std::string::npos) << entry.path();
}

TEST_F(View, EndsAfterSoManyFrames) {
    const RunResult run =
        run_weft(arguments({"--frames", "5", "--fixed-dt", "0.1", "--stats", folder_ / "stats.json"}));
    EXPECT_EQ(run.exit_code, 0) << run.text();
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(stats()["frames"], 5);
}

TEST_F(View, EndsWellOnASignal) {
    for (const int signal : {SIGINT, SIGTERM}) {
        RunningProgram program(arguments({"--output", folder_ / "last.png"}));
        ASSERT_TRUE(program.says("weft: watching")) << program.err();
        program.send(signal);
        EXPECT_EQ(program.exit_code(), 0) << program.err();
        EXPECT_TRUE(fs::remove(folder_ / "last.png"));
    }
}

TEST_F(View, WaitsForAGraphThatIsBrokenFromTheStart) {
    const std::string graph = read_text(folder_ / "live.json"), shader = read_text(folder_ / "tint.glsl");
    save("live.json", "{");
    save("tint.glsl", "broken");
    RunningProgram program(arguments({"--output", folder_ / "last.png"}));
    ASSERT_TRUE(program.says("weft: waiting for an edit that corrects the graph")) << program.err();
    EXPECT_TRUE(program.says("live.json:1:")) << program.err();
    save("live.json", graph);
    ASSERT_TRUE(program.says("weft: waiting for an edit that corrects the graph", 2)) << program.err();
    EXPECT_TRUE(program.says("tint.glsl:1:")) << program.err();
    save("tint.glsl", shader);
    ASSERT_TRUE(program.says("weft: watching")) << program.err();
    ASSERT_TRUE(program.says("weft: wrote")) << program.err();
    program.close_stdin();
    EXPECT_EQ(program.exit_code(), 0) << program.err();
}

TEST_F(View, EndsWhileItWaitsForAGraph) {
    save("live.json", "{");
    RunningProgram program(arguments());
    ASSERT_TRUE(program.says("weft: waiting for an edit that corrects the graph")) << program.err();
    program.send(SIGINT);
    EXPECT_EQ(program.exit_code(), 3) << program.err();
    // In three cases, `weft view` must end instead of waiting for an edit: stdin has ended, the command line
    // gives a number of frames, or the graph file is missing.
    EXPECT_EQ(run_weft(arguments()).exit_code, 3);
    const RunResult script = run_weft(arguments({"--frames", "5"}));
    EXPECT_EQ(script.exit_code, 3);
    EXPECT_EQ(script.err.find("waiting"), std::string::npos) << script.text();
    fs::remove(folder_ / "live.json");
    RunningProgram misspelt(arguments());
    EXPECT_EQ(misspelt.exit_code(), 3) << misspelt.err();
}

TEST_F(View, WritesThePictureAfterEachReload) {
    const auto picture = [&] { return read_text(folder_ / "last.png"); };
    RunningProgram program(arguments({"--output", folder_ / "last.png"}));
    ASSERT_TRUE(program.says("weft: wrote")) << program.err();
    const std::string first = picture();
    replace("tint.glsl", "0.75", "0.25");
    ASSERT_TRUE(program.says("weft: wrote", 2)) << program.err();
    const std::string second = picture();
    EXPECT_TRUE(second.starts_with("\x89PNG"));
    EXPECT_NE(second, first);
    program.close_stdin();
    EXPECT_EQ(program.exit_code(), 0) << program.err();
}

// Stdin is closed, as in a script. `weft view` then ends immediately, but must render one picture first.
TEST_F(View, DrawsAFrameThoughItsInputHasEnded) {
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    const ScratchFolder folder;
    const RunResult view = run_program({"sh", "-c",
                                        std::string(WEFT_PROGRAM) + " view builtin:spheres --graph " +
                                            kDeferredGraph + " --headless --probes none --size 64x36 -o " +
                                            (folder / "view.png") + " </dev/null"});
    ASSERT_EQ(view.exit_code, 0) << view.text();
    const RunResult render =
        run_weft({"render", "builtin:spheres", "--size", "64x36", "-o", folder / "render.png"});
    ASSERT_EQ(render.exit_code, 0) << render.text();
    EXPECT_EQ(read_text(folder / "view.png"), read_text(folder / "render.png"));
}

}  // namespace
}  // namespace weft::test
