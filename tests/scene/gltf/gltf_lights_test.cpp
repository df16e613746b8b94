// Purpose: tests glTF lights with shapes and functions from `extras.weft`, and lights with faults.
#include <cmath>

#include "tests/scene/gltf/gltf_fixture.h"

namespace weft::scene::test {
namespace {

class GltfLights : public GltfTest {
 protected:
    static GltfText with_light(const std::string& light, const std::string& node = "") {
        GltfText text;
        text.members["extensionsUsed"] = R"(["KHR_lights_punctual"])";
        text.members["extensions"] = R"({"KHR_lights_punctual":{"lights":[)" + light + "]}}";
        text.members["nodes"] =
            R"([{"mesh":0,)" + node + R"("extensions":{"KHR_lights_punctual":{"light":0}}}])";
        return text;
    }
    Light only_light(const std::string& light, const std::string& node = "") {
        const Scene scene = load(with_light(light, node));
        return scene.lights.size() == 1 ? scene.lights[0] : Light{};
    }
    [[nodiscard]] std::string first_warning() const { return warnings_.empty() ? "" : where(warnings_[0]); }
};

TEST_F(GltfLights, RectanglesHaveTheirCandelaStraightAhead) {
    const Light light = only_light(
        R"({"type":"spot","intensity":60,"spot":{},"extras":{"weft":{"type":"rectangle","size":[2,3]}}})");
    EXPECT_EQ(light.type, LightType::rectangle);
    EXPECT_FLOAT_EQ(light.intensity, 10);
    EXPECT_EQ(light.half_size_m, glm::vec2(1, 1.5f));
    expect_near(light.direction, {0, 0, -1});
    expect_near(light.side, {1, 0, 0});
    EXPECT_EQ(first_warning(), "");
}

TEST_F(GltfLights, CapsulesLieAlongTheirNodesX) {
    // The node is rotated by 90° about z, which maps x to y. So the capsule extends along y.
    const Light light = only_light(
        R"({"type":"point","intensity":5,"extras":{"weft":{"type":"capsule","length":2,"radius":0.25}}})",
        R"("rotation":[0,0,0.70710678,0.70710678],)");
    EXPECT_EQ(light.type, LightType::capsule);
    EXPECT_EQ(light.half_size_m, glm::vec2(1, 0.25f));
    EXPECT_NEAR(light.intensity, 5 / (0.5f * 2 + 3.14159265f * 0.0625f), 1e-4f);
    expect_near(light.direction, {0, 1, 0});
    expect_near(light.side, {0, 0, -1});
}

TEST_F(GltfLights, FunctionsAreReadWithTheirPicture) {
    GltfText text = with_light(R"({"type":"point","extras":{"weft":{"function":{
        "doors":[0.1,0.2,0.3,0.4],"softness":0.05,"falloff":{"curve":[1,2,3,0],"reach":4},
        "picture":{"index":0,"halfSize":[0.5,0.6]}}}}})");
    text.members["images"] = R"([{"uri":")" + data_uri(png(1, 1, Bytes{10, 20, 30, 255})) + R"("}])";
    text.members["textures"] = R"([{"source":0}])";
    const Scene scene = load(text);
    ASSERT_EQ(scene.lights.size(), 1u);
    ASSERT_EQ(scene.lights[0].function, 0u);
    const LightFunction& function = scene.light_functions.at(0);
    EXPECT_EQ(function.doors, glm::vec4(0.1f, 0.2f, 0.3f, 0.4f));
    EXPECT_FLOAT_EQ(function.softness, 0.05f);
    EXPECT_EQ(function.curve, glm::vec4(1, 2, 3, 0));
    EXPECT_FLOAT_EQ(function.reach_m, 4);
    EXPECT_EQ(function.picture_half_size, glm::vec2(0.5f, 0.6f));
    EXPECT_FALSE(function.parallel);
    ASSERT_LT(function.picture, scene.textures.size());
    EXPECT_EQ(scene.textures[function.picture].mips.at(0).at(1), 20);
    EXPECT_EQ(first_warning(), "");
}

TEST_F(GltfLights, WhatIsOutOfRangeIsClamped) {
    struct Case {
        const char* light;
        const char* place;
    };
    const std::string root = "S154 /extensions/KHR_lights_punctual/lights/0";
    for (const Case& c : {
             Case{R"({"type":"point","range":0})", "/range"},
             Case{R"({"type":"point","range":-3})", "/range"},
             Case{R"({"type":"point","intensity":-1})", "/intensity"},
             Case{R"({"type":"spot","spot":{"outerConeAngle":2}})", "/spot/outerConeAngle"},
             Case{R"({"type":"spot","spot":{"innerConeAngle":0.5,"outerConeAngle":0.5}})", "/spot"},
             Case{R"({"type":"spot","spot":{"innerConeAngle":1}})", "/spot"},
             Case{R"({"type":"point","extras":{"weft":{"type":"rectangle","size":[0,1]}}})",
                  "/extras/weft/size"},
             Case{R"({"type":"point","extras":{"weft":{"type":"rectangle","size":[1e17,1]}}})",
                  "/extras/weft/size"},
             Case{R"({"type":"point","extras":{"weft":{"type":"capsule","radius":-1}}})",
                  "/extras/weft/radius"},
             Case{R"({"type":"point","extras":{"weft":{"type":"capsule","length":-1}}})",
                  "/extras/weft/length"},
             Case{R"({"type":"point","extras":{"weft":{"function":{"doors":[9,0,0,0]}}}})",
                  "/extras/weft/function/doors"},
             Case{R"({"type":"point","extras":{"weft":{"function":{"softness":-1}}}})",
                  "/extras/weft/function/softness"},
             Case{R"({"type":"point","extras":{"weft":{"function":{"falloff":{"curve":[1,-1,0,0]}}}}})",
                  "/extras/weft/function/falloff/curve"},
             Case{R"({"type":"point","extras":{"weft":{"function":{"falloff":{"reach":0}}}}})",
                  "/extras/weft/function/falloff/reach"},
         }) {
        warnings_.clear();
        const Light light = only_light(c.light);
        EXPECT_EQ(first_warning(), root + c.place) << c.light;
        EXPECT_TRUE(std::isfinite(light.intensity) && light.intensity >= 0) << c.light;
        EXPECT_GE(light.range_m, 0);
        EXPECT_LE(light.inner_cone_rad, light.outer_cone_rad);
        EXPECT_LE(light.outer_cone_rad, 1.5708f);
    }
}

TEST_F(GltfLights, WhatIsNoLightIsRefusedWhereItIsWritten) {
    struct Case {
        const char* light;
        const char* where;
    };
    const std::string root = "/extensions/KHR_lights_punctual/lights/0/extras/weft";
    for (const Case& c : {
             Case{R"({"type":"point","extras":{"weft":7}})", "S108 "},
             Case{R"({"type":"point","extras":{"weft":{"type":"ring"}}})", "S108 /type"},
             Case{R"({"type":"point","extras":{"weft":{"type":3}}})", "S108 /type"},
             Case{R"({"type":"directional","extras":{"weft":{"type":"capsule"}}})", "S108 /type"},
             Case{R"({"type":"point","extras":{"weft":{"type":"rectangle","size":[1]}}})", "S108 /size"},
             Case{R"({"type":"point","extras":{"weft":{"type":"rectangle","size":[1,1e30]}}})", "S108 /size"},
             Case{R"({"type":"point","extras":{"weft":{"function":[]}}})", "S108 /function"},
             Case{R"({"type":"point","extras":{"weft":{"function":{"picture":{}}}}})",
                  "S108 /function/picture"},
             Case{R"({"type":"point","extras":{"weft":{"function":{"picture":{"index":4}}}}})",
                  "S110 /function/picture/index"},
         }) {
        const std::string found = where(fail(with_light(c.light)));
        const std::string code(c.where, 5);
        EXPECT_EQ(found, code + root + (c.where + 5)) << c.light;
    }
}

TEST_F(GltfLights, UnknownKeysAreNamed) {
    (void)only_light(R"({"type":"point","extras":{"weft":{"gobo":1},"blender":{"type":7}}})");
    EXPECT_EQ(first_warning(), "S153 /extensions/KHR_lights_punctual/lights/0/extras/weft/gobo");
    EXPECT_EQ(warnings_.size(), 1u);
}

}  // namespace
}  // namespace weft::scene::test
