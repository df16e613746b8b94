// Tests `weft scene`: the summary, the sources of light probes, the JSON, the picture and the written scene.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/viewer/gltf_file.h"
#include "tests/viewer/program.h"

namespace weft::test {
namespace {

constexpr const char* kFile = R"({ "version": 1,
  "volume": { "origin": [0, 1, 0], "spacing": 0.5, "size": [2, 1, 1] },
  "reflections": [{ "name": "above", "position": [0, 3, 0], "box": { "center": [0, 2, 0], "size": [4, 4, 5] } }] })";

class SceneCommand : public testing::Test {
 protected:
    SceneCommand() { scratch_.write("square.gltf", square_gltf()); }
    [[nodiscard]] RunResult run(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), {"scene", "square.gltf"});
        return run_weft(arguments, {}, scratch_.path());
    }
    // Expects success and these words in the printed text.
    void expect_words(const std::vector<std::string>& arguments,
                      const std::vector<std::string>& words) const {
        const RunResult result = run(arguments);
        EXPECT_EQ(result.exit_code, 0) << result.text();
        for (const std::string& word : words)
            EXPECT_NE(result.out.find(word), std::string::npos) << word << "\n" << result.text();
    }

    ScratchFolder scratch_;
};

TEST_F(SceneCommand, PrintsTheProbesThatItPlaces) {
    expect_words({}, {"1 instance of 1 mesh, 2 triangles", "probes, placed automatically",
                      "level 0: spacing 0.5 m", "reflection: 2 probes", "memory on the GPU"});
    expect_words({"--probes", "none"}, {"1 instance of 1 mesh", "probes: none"});
}

TEST_F(SceneCommand, ReadsTheFileBesideTheScene) {
    scratch_.write("square.probes.json", kFile);
    const std::vector<std::string> words{"probes from square.probes.json", "irradiance: 2 probes",
                                         "spacing 0.5 m, 0 cells", "above at 0, 3, 0, box of 4, 4, 5 m"};
    expect_words({}, words);
    expect_words({"--probes", "auto"}, {"placed automatically"});
    expect_words({"--probes", "none"}, {"probes: none"});
    const RunResult folder = run_weft({"scene", "."}, {}, scratch_.path());
    EXPECT_NE(folder.out.find("./square.probes.json"), std::string::npos) << folder.text();
}

TEST_F(SceneCommand, DoesNotFollowALinkBesideTheScene) {
    const ScratchFolder other;
    other.write("probes.json", kFile);
    std::filesystem::create_symlink(other / "probes.json", scratch_ / "square.probes.json");
    expect_words({}, {"placed automatically"});
    expect_words({"--probes", other / "probes.json"}, {"irradiance: 2 probes"});
}

TEST_F(SceneCommand, TheJsonIsAFileWithProbes) {
    const RunResult json = run({"--json"});
    ASSERT_EQ(json.exit_code, 0) << json.text();
    scratch_.write("square.probes.json", json.out);
    EXPECT_EQ(run({"--json"}).out, json.out);
    expect_words({}, {"probes from square.probes.json"});
}

TEST_F(SceneCommand, NamesTheFaultsOfAFile) {
    const RunResult missing = run({"--probes", "no.json"});
    EXPECT_EQ(missing.exit_code, 3);
    EXPECT_NE(missing.err.find("W002"), std::string::npos) << missing.text();
    scratch_.write("square.probes.json",
                   "{ \"version\": 1,\n  \"volume\": { \"spacing\": 1, \"size\": [1, 1, 1] } }");
    const RunResult faulty = run({});
    EXPECT_EQ(faulty.exit_code, 3);
    EXPECT_NE(faulty.err.find("square.probes.json:2:13: error[S196]: the key \"origin\" is missing"),
              std::string::npos)
        << faulty.text();
}

TEST_F(SceneCommand, DrawsAPicture) {
    expect_words({"-o", "probes.png"}, {"placed automatically"});
    EXPECT_TRUE(read_text(scratch_ / "probes.png").starts_with("\x89PNG"));
    const RunResult empty = run({"--probes", "none", "-o", "none.png"});
    EXPECT_EQ(empty.exit_code, 0) << empty.text();
}

TEST_F(SceneCommand, WritesTheSceneAndItsSky) {
    const RunResult written = run({"--gltf", "copy.glb", "--sky", "sky.hdr"});
    EXPECT_EQ(written.exit_code, 0) << written.text();
    const RunResult copy = run_weft({"scene", "copy.glb"}, {}, scratch_.path());
    EXPECT_EQ(copy.exit_code, 0) << copy.text();
    EXPECT_EQ(copy.err, "");
    EXPECT_NE(copy.out.find("1 instance of 1 mesh, 2 triangles"), std::string::npos) << copy.text();
    EXPECT_TRUE(read_text(scratch_ / "sky.hdr").starts_with("#?RADIANCE"));
}

TEST_F(SceneCommand, SaysWhyTheSceneCannotBeWritten) {
    const RunResult missing = run({"--gltf", "no/copy.glb"});
    EXPECT_EQ(missing.exit_code, 1) << missing.text();
    EXPECT_NE(missing.err.find("no/copy.glb: error[X510]"), std::string::npos) << missing.text();
    const RunResult named = run({"--gltf", "copy.gltf"});
    EXPECT_EQ(named.exit_code, 2) << named.text();
    EXPECT_NE(named.err.find("--gltf: the scene is a .glb file"), std::string::npos) << named.text();
    const RunResult sky = run({"--sky", "sky.png"});
    EXPECT_EQ(sky.exit_code, 2) << sky.text();
    EXPECT_NE(sky.err.find("--sky: the picture of the sky is a .hdr file"), std::string::npos) << sky.text();
}

}  // namespace
}  // namespace weft::test
