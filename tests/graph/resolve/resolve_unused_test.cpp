// Tests the warnings about unused declarations and useless passes, and correct graphs that must give no
// warning.
#include <algorithm>

#include "tests/graph/resolve/resolve_fixture.h"

namespace weft::test {
namespace {

class ResolveUnused : public ResolveTest {
 protected:
    ResolveUnused() {
        shaders["filter.comp"] = compute({sampled("src"), image_out("dst")});
        shaders["draw"] = fragment({"color"});
    }

    // Returns the warnings for a graph as texts such as "W130 name", sorted.
    std::vector<std::string> warned(const std::string& body) {
        warnings.clear();
        good(body);
        std::vector<std::string> found;
        for (const Diagnostic& d : warnings) {
            EXPECT_EQ(d.severity, Severity::warning);
            EXPECT_FALSE(d.help.empty());
            EXPECT_GT(d.line, 0u);
            const size_t begin = d.message.find('"') + 1;
            found.push_back(d.code + " " + d.message.substr(begin, d.message.find('"', begin) - begin));
        }
        std::sort(found.begin(), found.end());
        return found;
    }

    using Names = std::vector<std::string>;
};

const std::string kTwo = R"j("resources": {"x": "rgba16f", "y": "rgba16f"}, "passes": {
  "c": {"type": "clear", "out": ["x", "y"]}, "r": {"type": "readback", "in": ["x"]}})j";

TEST_F(ResolveUnused, WrittenButNeverRead) {
    EXPECT_EQ(warned(kTwo), Names{"W135 y"});
    EXPECT_EQ(warned(kTwo + R"j(, "debug": {"Y": {"show": "y.mip(0)"}})j"), Names{});
    EXPECT_EQ(warned(kTwo + R"j(, "tests": [{"expect": {"finite": ["y.mip(0)"]}}])j"), Names{});
    observed = {"y"};
    EXPECT_EQ(warned(kTwo), Names{});
}

TEST_F(ResolveUnused, KeptContentIsForTheNextFrame) {
    EXPECT_EQ(warned(R"j("resources": {"x": "rgba16f", "y": {"format": "rgba16f", "keep": true}}, "passes": {
      "c": {"type": "clear", "out": ["x", "y"]}, "r": {"type": "readback", "in": ["x"]}})j"),
              Names{});
}

TEST_F(ResolveUnused, DepthServesItsTestAndSamplesTheirResolve) {
    const auto body = [](const std::string& state) {
        return R"j("imports": {"opaque": "drawlist"}, "resources": {
          "many": {"format": "rgba16f", "samples": 4}, "one": "rgba16f", "z": {"format": "d32f", "samples": 4}},
        "passes": {
          "d": {"type": "raster", "draws": ["opaque"], "shader": "draw", "out": {"color": "many"}, "depth": "z",
                "resolve": {"one": "color"}, "state": {"depth": ")j" +
               state + R"j("}}, "r": {"type": "readback", "in": ["one"]}})j";
    };
    EXPECT_EQ(warned(body("greater_write")), Names{});
    EXPECT_EQ(warned(body("always_write")), Names{}) << "a test that always passes is one";
}

TEST_F(ResolveUnused, OfPassesThatFallTogetherTheLastIsTheCause) {
    EXPECT_EQ(warned(R"j("resources": {"x": "rgba16f", "y": "rgba16f", "z": "rgba16f"}, "passes": {
      "c": {"type": "clear", "out": ["x", "z"]}, "r": {"type": "readback", "in": ["z"]},
      "f": {"type": "compute", "shader": "filter.comp", "in": {"src": "x"}, "out": {"dst": "y"}}})j"),
              Names{"W136 f"});
    EXPECT_NE(warnings[0].message.find("no pass reads \"y\""), std::string::npos) << warnings[0].message;
    EXPECT_EQ(warned(R"j("resources": {"x": "rgba16f", "y": "rgba16f"}, "passes": {
      "c": {"type": "clear", "out": ["x"]},
      "f": {"type": "compute", "shader": "filter.comp", "in": {"src": "x"}, "out": {"dst": "y"}}})j"),
              Names{"W136 f"});
}

TEST_F(ResolveUnused, WhatAConditionLeavesOutExplainsIt) {
    const auto body = [](const std::string& reader) {
        return R"j("params": {"on": false}, "resources": {"x": "rgba16f", "y": "rgba16f", "z": "rgba16f"}, "passes": {
          "c": {"type": "clear", "out": ["x"]}, "d": {"type": "clear", "out": ["z"]},
          "f": {"type": "compute", "shader": "filter.comp", "if": "on", "in": {"src": "x"}, "out": {"dst": "y"}},
          "r": {"type": "readback", "in": {"src": )j" +
               reader + "}}}";
    };
    EXPECT_EQ(warned(body(R"j({"ref": "y", "else": "z"})j")), Names{});
    params["on"] = 1;
    EXPECT_EQ(warned(body(R"j({"ref": "y", "else": "z"})j")), Names{}) << "d is for the other case";
}

TEST_F(ResolveUnused, RepeatsAreUselessAsAWhole) {
    const auto body = [](const std::string& read) {
        return R"j("resources": {"x": {"format": "rgba16f", "layers": 3}, "y": "rgba16f"}, "passes": {
          "c": {"type": "clear", "repeat": {"i": "0..2"}, "out": ["x.layer(i)"]},
          "d": {"type": "clear", "out": ["y"]},
          "r": {"type": "readback", "in": {"src": ")j" +
               read + "\"}}}";
    };
    EXPECT_EQ(warned(body("x.layer(1)")), Names{"W136 d"});
    EXPECT_EQ(warned(body("y")), Names{"W136 c"});
}

TEST_F(ResolveUnused, Imports) {
    const std::string body =
        R"j("imports": {"opaque": "drawlist", "noise": "image"}, "resources": {"x": "rgba16f"},
      "passes": {"c": {"type": "clear", "out": ["x"]}, "r": {"type": "readback", "in": ["x"]}})j";
    EXPECT_EQ(warned(body), (Names{"W134 noise", "W134 opaque"}));
    EXPECT_EQ(warned(body + R"j(, "debug": {"Noise": {"show": "noise"}})j"), Names{"W134 opaque"});
    EXPECT_EQ(warned(body + R"j(, "frames": "opaqueDraws")j"), Names{"W134 noise"})
        << "its draws are counted";
}

TEST_F(ResolveUnused, Turns) {
    const std::string body = R"j("imports": {"spin": "turns"}, "params": {"speed": 1, "start": 1, "more": 1},
      "resources": {"x": {"format": "rgba16f", "layers": 2, "keep": true}},
      "passes": {"r": {"type": "readback", "repeat": {"j": "0..1"}, "in": {"src": "x.layer(j)"}}},
      "groups": {"g": {"repeat": {"i": "0..1"}, "perFrame": "speed", "rest": true, "settle": "more",)j";
    const std::string last = R"j("passes": {"c": {"type": "clear", "out": {"dst": "x.layer(i)"}}}}})j";
    EXPECT_EQ(warned(body + R"j("turns": "spin", "warmUp": "start",)j" + last), Names{});
    EXPECT_EQ(warned(body + last), (Names{"W132 start", "W134 spin"}));
}

}  // namespace
}  // namespace weft::test
