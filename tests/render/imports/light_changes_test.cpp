// Purpose: tests which lights count as changed between two frames.
#include "render/imports/light_changes.h"

#include <gtest/gtest.h>

namespace weft::render {
namespace {

using shared::Light;
using shared::LightChange;

Light lamp(float x, float candela) {
    Light light{};
    light.type = shared::kLightPoint;
    light.position = {x, 0, 0};
    light.intensity = {candela, 0.5f * candela, 0};
    return light;
}

TEST(LightChanges, EqualListsHaveNone) {
    const std::vector<Light> lights{lamp(1, 5), lamp(2, 6)};
    EXPECT_TRUE(light_changes(lights, lights).empty());
    EXPECT_TRUE(light_changes({}, {}).empty());
}

TEST(LightChanges, ALampThatMovesOrDimsIsOneChange) {
    const std::vector<Light> before{lamp(1, 5), lamp(2, 6)}, now{lamp(1, 5), lamp(3, 4)};
    const std::vector<LightChange> changes = light_changes(before, now);
    ASSERT_EQ(changes.size(), 1u);
    EXPECT_EQ(changes[0].position_before.x, 2);
    EXPECT_EQ(changes[0].position.x, 3);
    EXPECT_EQ(changes[0].intensity_before, 6);
    EXPECT_EQ(changes[0].intensity, 4);
}

// The list of a frame has only lights that are on, so a lamp that goes off moves the places of all others.
TEST(LightChanges, ALampThatGoesOffOrOnIsTheOnlyChange) {
    const std::vector<Light> three{lamp(1, 5), lamp(2, 6), lamp(2, 6)}, two{lamp(1, 5), lamp(2, 6)};
    const std::vector<LightChange> off = light_changes(three, two), on = light_changes(two, three);
    ASSERT_EQ(off.size(), 1u);
    EXPECT_EQ(off[0].intensity_before, 6);
    EXPECT_EQ(off[0].intensity, 0);
    ASSERT_EQ(on.size(), 1u);
    EXPECT_EQ(on[0].intensity_before, 0);
    EXPECT_EQ(on[0].intensity, 6);
    EXPECT_EQ(on[0].position.x, 2);
}

TEST(LightChanges, ALampThatTurnsGoesOffAndOn) {
    Light before = lamp(1, 5), now = before;
    before.type = now.type = shared::kLightSpot;
    before.direction = {0, -1, 0};
    now.direction = {1, 0, 0};
    const std::vector<LightChange> changes = light_changes(std::span(&before, 1), std::span(&now, 1));
    ASSERT_EQ(changes.size(), 2u);
    EXPECT_EQ(changes[0].intensity_before + changes[1].intensity_before, 5);
    EXPECT_EQ(changes[0].intensity + changes[1].intensity, 5);
}

// The illuminance of a sun is intensity / distance².
TEST(LightChanges, ASunIsAFarLamp) {
    Light before{}, now{};
    before.type = now.type = shared::kLightDirectional;
    before.direction = now.direction = {0, -1, 0};
    before.intensity = glm::vec3(100'000);
    now.intensity = glm::vec3(90'000);
    const std::vector<LightChange> changes = light_changes(std::span(&before, 1), std::span(&now, 1));
    ASSERT_EQ(changes.size(), 1u);
    const float far2 = glm::dot(changes[0].position, changes[0].position);
    EXPECT_NEAR(changes[0].intensity_before / far2, 100'000, 1);
    EXPECT_NEAR(changes[0].intensity / far2, 90'000, 1);
    EXPECT_GT(changes[0].position.y, 0) << "the light comes from above";
}

TEST(LightChanges, TheStrongestAreKept) {
    std::vector<Light> before, now;
    for (int i = 0; i < 200; ++i) {
        before.push_back(lamp(float(i), 1 + float(i % 7) + float(i)));
        now.push_back(lamp(float(i) + 0.5f, 1 + float(i % 7) + float(i)));
    }
    const std::vector<LightChange> changes = light_changes(before, now);
    ASSERT_EQ(changes.size(), size_t{shared::kMostLightChanges});
    for (size_t i = 1; i < changes.size(); ++i) EXPECT_LE(changes[i].intensity, changes[i - 1].intensity);
    EXPECT_GE(changes.back().intensity, 200 - 64);
}

}  // namespace
}  // namespace weft::render
