// Tests --graph-path and modules with the program: the commands that read graphs find a folder with a graph
// and its shaders, also in the sandbox.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/viewer/gltf_file.h"
#include "tests/viewer/program.h"

namespace weft::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFogbank = R"({
  "version": 1, "imports": { "backbuffer": "output" }, "ports": { "sky": "any image" },
  "params": { "bias": 1 }, "resources": { "sky": "rgba8", "fog": "rgba8" },
  "passes": {
    "clear": { "type": "clear", "out": ["sky"], "clear": 1 },
    "fog":   { "type": "compute", "shader": "fog.comp", "in": ["sky"], "out": ["fog"] },
    "show":  { "type": "copy", "in": ["fog"], "out": ["backbuffer"] }
  },
  "debug": { "Fog": "fog" }
})";
constexpr const char* kFogShader = R"(#version 460
#include "amount.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
uniform sampler2D sky;
writeonly uniform image2D fog;
layout(push_constant) uniform Params { float bias; } params;
void main() {
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    imageStore(fog, at, texelFetch(sky, at, 0) * amount + params.bias);
}
)";

class GraphPath : public testing::Test {
 protected:
    GraphPath() {
        scratch_.write("lib/fogbank/fog.json", kFogbank);
        scratch_.write("lib/fogbank/fog.comp", kFogShader);
        scratch_.write("lib/fogbank/amount.glsl", "const float amount = 0.5;\n");
        scratch_.write("graph/g.json", R"({ "version": 1, "include": [
            { "file": "fogbank/fog.json", "as": "near" },
            { "file": "fogbank/fog.json", "as": "far", "with": { "sky": "near::fog" } }],
            "passes": { "near::show": null, "far::clear": null } })");
    }
    RunResult run(std::vector<std::string> words, bool with_path = true) const {
        if (with_path) words.insert(words.end(), {"--graph-path", scratch_ / "lib"});
        return run_weft(words, {}, scratch_.path());
    }

    ScratchFolder scratch_;
};

TEST_F(GraphPath, EveryCommandThatReadsGraphsFindsTheModule) {
    for (const std::vector<std::string>& words : {std::vector<std::string>{"check", "graph/g.json"},
                                                  {"check", "graph/g.json", "--sandbox"},
                                                  {"plan", "graph/g.json"},
                                                  {"plan", "graph/g.json", "--sandbox"},
                                                  {"plan", "graph/g.json", "--param", "far::bias=2"},
                                                  {"explain", "graph/g.json", "culled", "near::clear"},
                                                  {"diff", "graph/g.json", "graph/g.json"},
                                                  {"schema", "graph/g.json"}}) {
        const RunResult found = run(words);
        if (found.err.find("X595") != std::string::npos) continue;  // The kernel has no sandbox.
        EXPECT_EQ(found.exit_code, 0) << found.text();
        const RunResult missing = run(words, false);
        EXPECT_EQ(missing.exit_code, 3) << missing.text();
        EXPECT_NE(missing.err.find("error[W126]"), std::string::npos) << missing.text();
    }
}

TEST_F(GraphPath, PlansAndMessagesShowTheFullNames) {
    const RunResult plan = run({"plan", "graph/g.json"});
    ASSERT_EQ(plan.exit_code, 0) << plan.text();
    for (const char* name : {"near::fog", "far::fog", "fogbank/fog.comp", "near::bias"})
        EXPECT_NE(plan.out.find(name), std::string::npos) << name << "\n" << plan.out;
    const RunResult wrong = run({"plan", "graph/g.json", "--param", "far::bais=2"});
    EXPECT_EQ(wrong.exit_code, 3) << wrong.text();
    EXPECT_NE(wrong.err.find("did you mean \"far::bias\""), std::string::npos) << wrong.text();
}

TEST_F(GraphPath, TheFolderRunsByItsPathAndAsACopy) {
    const RunResult by_path = run({"check", "lib/fogbank/fog.json"}, false);
    EXPECT_EQ(by_path.exit_code, 0) << by_path.text();
    fs::copy(scratch_ / "lib/fogbank", scratch_ / "graph/fogbank", fs::copy_options::recursive);
    const RunResult copied = run({"check", "graph/g.json"}, false);
    EXPECT_EQ(copied.exit_code, 0) << copied.text();
}

TEST_F(GraphPath, MustBeAFolder) {
    for (const std::string& place : {scratch_ / "none", scratch_ / "graph/g.json"}) {
        const RunResult bad = run({"check", "graph/g.json", "--graph-path", place}, false);
        EXPECT_EQ(bad.exit_code, 2) << bad.text();
        EXPECT_NE(bad.err.find("is not a folder"), std::string::npos) << bad.text();
    }
}

TEST_F(GraphPath, TheSchemaOfAGraphKnowsTheNamesOfModules) {
    const RunResult schema = run({"schema", "graph/g.json"});
    ASSERT_EQ(schema.exit_code, 0) << schema.text();
    const nlohmann::json root = nlohmann::json::parse(schema.out);
    const nlohmann::json& definitions = root.at("definitions");
    const auto has = [](const nlohmann::json& names, const char* name) {
        return std::find(names.begin(), names.end(), name) != names.end();
    };
    EXPECT_TRUE(has(definitions.at("passName").at("enum"), "near::fog")) << definitions.at("passName");
    EXPECT_TRUE(has(definitions.at("paramName").at("enum"), "far::bias"));
    const nlohmann::json& pass =
        definitions.at("ownPasses").at("properties").at("near::fog").at("properties");
    EXPECT_TRUE(has(pass.at("params").at("propertyNames").at("enum"), "bias")) << pass;
}

TEST_F(GraphPath, PicturesReadbacksAndDebugViewsNameParts) {
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    const auto render = [&](std::vector<std::string> more) {
        std::vector<std::string> words{"render",  "builtin:spheres", "--graph",    "graph/g.json",
                                       "--size",  "32x16",           "--validate", "-o",
                                       "out.png", "--stats",         "stats.json"};
        words.insert(words.end(), more.begin(), more.end());
        const RunResult drawn = run(words);
        EXPECT_EQ(drawn.exit_code, 0) << drawn.text();
        return nlohmann::json::parse(read_text(scratch_ / "stats.json"))
            .at("output_sha256")
            .get<std::string>();
    };
    const std::string plain = render({});
    EXPECT_EQ(render({"--sandbox"}), plain);
    EXPECT_EQ(render({"--param", "near::bias=-0.25", "--resource", "near::fog"}),
              render({"--param", "near::bias=-0.25", "--param", "far::bias=7", "--resource", "near::fog"}));
    EXPECT_NE(render({"--param", "far::bias=-0.25", "--resource", "far::fog"}),
              render({"--param", "far::bias=0", "--resource", "far::fog"}));
    render({"--debug", "near::Fog"});
}

}  // namespace
}  // namespace weft::test
