// Purpose: tests that wrong numbers in lights and light functions are replaced by numbers that can be drawn,
// and that the warnings name these faults. Also tests the pictures of light functions.
#include "scene/model/light_check.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "scene/pictures/light_pictures.h"

namespace weft::scene {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

bool drawable(const Light& light) {
    for (const float x :
         {light.intensity, light.range_m, light.inner_cone_rad, light.outer_cone_rad, light.position.x,
          light.position.y, light.position.z, light.color.x, light.half_size_m.x, light.half_size_m.y})
        if (!std::isfinite(x)) return false;
    const bool units =
        std::abs(glm::length(light.direction) - 1) < 1e-3f && std::abs(glm::length(light.side) - 1) < 1e-3f;
    return units && std::abs(glm::dot(light.direction, light.side)) < 1e-3f && light.intensity >= 0 &&
           light.range_m >= 0 && light.inner_cone_rad <= light.outer_cone_rad &&
           light.outer_cone_rad <= 1.5708f;
}

TEST(LightCheck, GoodLightsStayAsTheyAre) {
    Light light;
    light.type = LightType::rectangle;
    light.half_size_m = {1, 2};
    light.range_m = 5;
    light.side = {0, 1, 0};
    EXPECT_EQ(clamp_light(light), "");
    EXPECT_EQ(light.half_size_m, glm::vec2(1, 2));
    EXPECT_EQ(light.side, glm::vec3(0, 1, 0));
    LightFunction function;
    EXPECT_EQ(clamp_light_function(function), "");
}

TEST(LightCheck, BadOnesAreClampedAndNamed) {
    const std::array<std::function<void(Light&)>, 16> faults{
        [](Light& l) { l.intensity = kNan; },
        [](Light& l) { l.intensity = kInfinity; },
        [](Light& l) { l.intensity = -1; },
        [](Light& l) { l.color.x = kNan; },
        [](Light& l) { l.range_m = -2; },
        [](Light& l) { l.range_m = kNan; },
        [](Light& l) { l.position.y = kNan; },
        [](Light& l) { l.position.z = kInfinity; },
        [](Light& l) { l.direction = glm::vec3(0); },
        [](Light& l) { l.direction = glm::vec3(kNan); },
        [](Light& l) { l.direction = glm::vec3(0, -7, 0); },
        [](Light& l) { l.side = l.direction; },
        [](Light& l) { l.outer_cone_rad = 2; },
        [](Light& l) { l.inner_cone_rad = 1.2f; },
        [](Light& l) {
            l.path = {glm::vec3(kNan), glm::vec3(0), 1, 0};
        },
        [](Light& l) {
            l.type = LightType::capsule;
            l.half_size_m = {kNan, 0};
        }};
    for (size_t i = 0; i < faults.size(); ++i) {
        Light light;
        light.type = LightType::spot;
        faults[i](light);
        EXPECT_NE(clamp_light(light), "") << i;
        EXPECT_TRUE(drawable(light)) << i;
        EXPECT_EQ(clamp_light(light), "") << i << ": once is enough";
    }
}

TEST(LightCheck, BadFunctionsAreClamped) {
    LightFunction function;
    function.doors = glm::vec4(kNan);
    function.curve = {kNan, -1, kInfinity, 1};
    function.softness = 0;
    function.reach_m = 0;
    function.picture_half_size = {0, kNan};
    EXPECT_NE(clamp_light_function(function), "");
    EXPECT_EQ(clamp_light_function(function), "");
    EXPECT_GT(function.reach_m, 0);
}

TEST(LightCheck, ManyFaultsAreToldInFewWarnings) {
    Scene scene;
    scene.lights.resize(1'000'000);
    for (Light& light : scene.lights) light.range_m = -1;
    scene.lights[0].name = "lamp";
    const Diagnostics warnings = light_warnings(scene);
    ASSERT_EQ(warnings.size(), 9u);
    EXPECT_EQ(warnings[0].code, "S158");
    EXPECT_EQ(warnings[0].message, "light \"lamp\": the range was not within its limits");
    EXPECT_EQ(warnings[8].message, "999992 further lights or light functions have wrong values, too");
}

TEST(LightPictures, AreResampledOnceEach) {
    Scene scene;
    scene.textures = {Texture{"grey", 2, 1, ColorSpace::linear, {{128, 128, 128, 255, 128, 128, 128, 255}}}};
    scene.light_functions.resize(4);
    scene.light_functions[1].picture = 0;
    scene.light_functions[2].picture = 0;
    scene.light_functions[3].picture = 9;
    const LightPictures pictures = light_pictures(scene);
    EXPECT_EQ(pictures.layers, 1u);
    const Diagnostics warnings = light_warnings(scene);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_EQ(warnings[0].message,
              "light function 3: the scene has no texture with the index of the picture");
    EXPECT_EQ(pictures.layer_of, (std::vector<uint32_t>{kNone, 0, 0, kNone}));
    ASSERT_EQ(pictures.mips.size(), 9u);
    EXPECT_EQ(pictures.mips[0].size(), size_t{kLightPictureSize_px} * kLightPictureSize_px * 4);
    EXPECT_EQ(pictures.mips[0][0], 188) << "half the light in sRGB";
    EXPECT_EQ(pictures.mips[8][0], 188);
}

}  // namespace
}  // namespace weft::scene
