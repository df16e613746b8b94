// Tests quality tiers on the command line: `weft check` checks all tiers together with one message per cause,
// and each tier can be planned and compared.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/viewer/program.h"

namespace weft::test {
namespace {

// Returns a graph with these tiers. `more` is the text of further passes; it is empty or ends with a comma.
// The resource `rays` is unused, unless a tier or a further pass uses it.
std::string graph_with(const std::string& tiers, const std::string& more = "") {
    return R"({
  "version": 1, "name": "tiers", "imports": { "backbuffer": "output" },
  "params": { "scale": { "default": 1, "range": [0.25, 1] } },
  "resources": { "hdr": { "format": "rgba16f", "size": "output * scale" }, "rays": "r8" },
  "passes": {
    "fill": { "type": "clear", "out": ["hdr"] },)" +
           more + R"(
    "show": { "type": "blit", "in": ["hdr"], "out": ["backbuffer"] }
  },
  "tiers": )" +
           tiers + "\n}\n";
}

nlohmann::json check(const ScratchFolder& folder, const std::string& graph, int exit_code) {
    folder.write("g.json", graph);
    const RunResult run = run_weft({"check", folder / "g.json", "--json"});
    EXPECT_EQ(run.exit_code, exit_code) << run.err;
    return nlohmann::json::parse(run.out);
}

TEST(TiersOfAFile, AreAllCheckedAtOnce) {
    const ScratchFolder folder;
    const nlohmann::json found = check(folder, graph_with(R"({
    "low":  { "set": { "scale": 0.5 }, "patch": { "passes": { "fill": { "out": ["hrd"] } } } },
    "high": { "set": { "scael": 1 } }
  })"),
                                       3);
    ASSERT_EQ(found.size(), 2u) << found.dump(1);
    EXPECT_EQ(found[0].at("code"), "W103");
    EXPECT_EQ(found[0].at("tier"), "low");
    EXPECT_EQ(found[0].at("line"), 10);
    EXPECT_EQ(found[0].at("pointer"), "/tiers/low/patch/passes/fill/out/0");
    EXPECT_EQ(found[1].at("code"), "W131");
    EXPECT_EQ(found[1].at("tier"), "high");
    EXPECT_EQ(found[1].at("pointer"), "/tiers/high/set/scael");
}

TEST(TiersOfAFile, AFaultOfTheFileIsSaidOnce) {
    const ScratchFolder folder;
    const nlohmann::json found = check(
        folder, graph_with(R"({ "low": {}, "high": {} })", R"( "fog": { "type": "clear", "out": ["fgo"] },)"),
        3);
    ASSERT_EQ(found.size(), 2u) << found.dump(1);
    EXPECT_EQ(found[0].at("code"), "W130");
    EXPECT_EQ(found[1].at("code"), "W103");
    EXPECT_TRUE(found[1].at("tier").is_null());
}

// One tier alone does not tell whether a resource is unused.
TEST(TiersOfAFile, APlanOfOneTierDoesNotSayThatSomethingIsUnused) {
    const ScratchFolder folder;
    folder.write("g.json", graph_with(R"({ "low": {}, "high": {} })"));
    for (const std::vector<std::string>& tier : {std::vector<std::string>{}, {"--tier", "low"}}) {
        std::vector<std::string> words{"plan", folder / "g.json"};
        words.insert(words.end(), tier.begin(), tier.end());
        const RunResult run = run_weft(words);
        EXPECT_EQ(run.exit_code, 0) << run.text();
        EXPECT_TRUE(run.err.empty()) << run.text();
    }
}

TEST(TiersOfAFile, WhatOneOfThemUsesIsNotUnused) {
    const ScratchFolder folder;
    EXPECT_EQ(check(folder, graph_with(R"({ "low": {} })"), 0).size(), 1u) << "nobody uses rays";
    EXPECT_EQ(
        check(folder, graph_with(R"({ "high": { "patch": { "passes": { "fill": { "out": ["rays"] } } } } })"),
              0)
            .size(),
        0u);
}

TEST(TiersOfAFile, ArePlannedAndCompared) {
    const ScratchFolder folder;
    folder.write("g.json", graph_with(R"({ "low": { "set": { "scale": 0.5 } }, "same": {} })"));
    const std::string file = folder / "g.json";
    const RunResult low = run_weft({"plan", file, "--tier", "low"}), base = run_weft({"plan", file});
    EXPECT_EQ(low.exit_code, 0) << low.err;
    EXPECT_NE(low.out, base.out);
    const RunResult diff = run_weft({"diff", file + ":low", file, "--json"});
    EXPECT_EQ(diff.exit_code, 0) << diff.err;
    EXPECT_FALSE(nlohmann::json::parse(diff.out).at("same").get<bool>());
    EXPECT_TRUE(
        nlohmann::json::parse(run_weft({"diff", file + ":same", file, "--json"}).out).at("same").get<bool>());
    const RunResult unknown = run_weft({"plan", file, "--tier", "lwo"});
    EXPECT_EQ(unknown.exit_code, 3);
    EXPECT_NE(unknown.err.find("W129"), std::string::npos) << unknown.err;
    EXPECT_NE(unknown.err.find("did you mean \"low\""), std::string::npos) << unknown.err;
}

// Resource `x` may have the format rgba8_srgb or rgba8. Only tier "high" uses `x` as a storage image, which
// rgba8_srgb does not support. All tiers share one format for `x`, so it is rgba8 even for the other tiers.
TEST(TiersOfAFile, ShareTheirFormats) {
    const ScratchFolder folder;
    folder.write("store.comp", R"(#version 460
layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba8) writeonly uniform image2D x;
void main() { imageStore(x, ivec2(gl_GlobalInvocationID.xy), vec4(1.0)); }
)");
    folder.write("g.json", R"({
  "version": 1, "name": "formats", "imports": { "backbuffer": "output" },
  "resources": { "x": "rgba8_srgb|rgba8" },
  "passes": { "make": { "type": "clear", "out": ["x"] }, "show": { "type": "blit", "in": ["x"], "out": ["backbuffer"] } },
  "tiers": { "low": {}, "high": { "patch": { "passes": {
    "make": null, "store": { "type": "compute", "shader": "store.comp", "out": ["x"] } } } } }
})");
    for (const char* tier : {"", "low", "high"}) {
        std::vector<std::string> words{"plan", folder / "g.json", "--format", "json"};
        if (*tier != 0) words.insert(words.end(), {"--tier", tier});
        const RunResult run = run_weft(words);
        ASSERT_EQ(run.exit_code, 0) << run.text();
        for (const nlohmann::json& resource : nlohmann::json::parse(run.out).at("graph").at("resources"))
            EXPECT_TRUE(resource.at("name") != "x" || resource.at("format") == "rgba8") << tier;
    }
}

}  // namespace
}  // namespace weft::test
