// Tests error messages of graphs: the messages show file paths as the user wrote them, and appear before slow
// work begins.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/viewer/program.h"

namespace weft::test {
namespace {

constexpr const char* kGraph = R"({
  "version": 1, "name": "my", "imports": { "backbuffer": "output" },
  "params": { "light": { "default": 1, "range": [0, 2] } },
  "passes": { "picture": { "type": "fullscreen", "shader": "picture.frag", "out": ["backbuffer"] } }
})";
constexpr const char* kShader = R"(#version 460
#include "tone.glsl"
layout(location = 0) out vec4 backbuffer;
layout(push_constant) uniform Params { float light; } params;
void main() { backbuffer = vec4(tone(params.light)); }
)";
constexpr const char* kTone = "float tone(float x) { return sqrtt(x); }\n";

class GraphErrors : public testing::Test {
 protected:
    GraphErrors() {
        std::filesystem::create_directories(folder_.path() / "mine");
        folder_.write("mine/my.json", kGraph);
        folder_.write("mine/picture.frag", kShader);
        folder_.write("mine/tone.glsl", kTone);
    }
    ScratchFolder folder_;
};

TEST_F(GraphErrors, OfShadersNameFilesAsTheGraphWasNamed) {
    const RunResult above = run_weft({"check", "mine/my.json"}, {}, folder_.path());
    EXPECT_EQ(above.exit_code, 3);
    EXPECT_TRUE(above.err.starts_with("mine/tone.glsl:1:")) << above.text();
    const RunResult beside = run_weft({"check", "my.json"}, {}, folder_.path() / "mine");
    EXPECT_TRUE(beside.err.starts_with("tone.glsl:1:")) << beside.text();
    const RunResult absolute = run_weft({"check", folder_ / "mine/my.json"});
    EXPECT_TRUE(absolute.err.starts_with(folder_ / "mine/tone.glsl")) << absolute.text();
}

// Two folders contain files with the same relative names. The cache of compiled shaders must not use the
// result of one folder for the other.
TEST_F(GraphErrors, FoldersThatAreCalledTheSameAreNotTakenForEachOther) {
    std::filesystem::create_directories(folder_.path() / "yours");
    folder_.write("mine/tone.glsl", "float tone(float x) { return x; }\n");
    folder_.write("yours/my.json", kGraph);
    folder_.write("yours/picture.frag", kShader);
    folder_.write("yours/tone.glsl", kTone);
    EXPECT_EQ(run_weft({"check", "my.json"}, {}, folder_.path() / "mine").exit_code, 0);
    EXPECT_EQ(run_weft({"check", "my.json"}, {}, folder_.path() / "yours").exit_code, 3);
}

TEST_F(GraphErrors, OfParametersComeBeforeTheSceneIsLoaded) {
    const RunResult run = run_weft(
        {"render", "nowhere.glb", "--graph", "mine/my.json", "--param", "light=3", "-o", folder_ / "x.png"},
        {}, folder_.path());
    EXPECT_EQ(run.exit_code, 3) << run.text();
    EXPECT_NE(run.err.find("W120"), std::string::npos) << run.text();
    EXPECT_EQ(run.err.find("nowhere.glb"), std::string::npos) << run.text();
}

TEST_F(GraphErrors, WhatAnIncludedFileOffersMayStayUnused) {
    folder_.write("mine/over.json",
                  R"({ "version": 1, "include": ["deferred.json"], "passes": { "tonemap": null,
      "show": { "type": "fullscreen", "shader": "show.frag", "in": ["hdr"], "out": ["backbuffer"] } } })");
    folder_.write("mine/show.frag", R"(#version 460
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 backbuffer;
uniform sampler2D hdr;
void main() { backbuffer = texture(hdr, uv); }
)");
    const RunResult over = run_weft({"check", "mine/over.json"}, {}, folder_.path());
    EXPECT_EQ(over.exit_code, 0) << over.text();
    EXPECT_EQ(over.err.find("W132"), std::string::npos) << over.text();
    folder_.write("mine/tone.glsl", "float tone(float x) { return x; }\n");
    std::string own(kGraph);
    own.insert(own.find("\"light\""), "\"fog\": 1, ");
    folder_.write("mine/my.json", own);
    const RunResult mine = run_weft({"check", "mine/my.json"}, {}, folder_.path());
    EXPECT_NE(mine.err.find("W132"), std::string::npos) << "in a file of one's own it is said\n"
                                                        << mine.text();
}

}  // namespace
}  // namespace weft::test
