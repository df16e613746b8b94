// Tests the positions, ranges and matrices of the sun's shadow maps, mostly with random cameras.
#include "render/views/sun_cascades.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <glm/gtc/matrix_transform.hpp>
#include <random>

namespace weft::test {
namespace {

constexpr float kAspect = 16.0f / 9;
constexpr render::SunMaps kMaps{3, {1024, 1024, 1024}};

class Random {
 public:
    explicit Random(uint32_t seed) : engine_(seed) {}
    double between(double least, double most) {
        return std::uniform_real_distribution<double>(least, most)(engine_);
    }
    glm::vec3 direction() {
        std::normal_distribution<float> normal;
        return glm::normalize(glm::vec3(normal(engine_), normal(engine_), normal(engine_)));
    }
    glm::mat4 turned(const glm::vec3& eye) {
        glm::vec3 back = direction();
        if (std::abs(back.y) > 0.98f) back = glm::vec3(0, 0, 1);
        return glm::inverse(glm::lookAt(eye, eye - back, glm::vec3(0, 1, 0)));
    }

 private:
    std::mt19937 engine_;
};

// A random camera, direction to the sun, and bounds of a scene (10 m to 120 m wide).
struct Shot {
    render::SunScene scene;
    scene::Camera camera;
};

Shot random_shot(Random& random) {
    Shot shot;
    shot.scene.to_sun = random.direction();
    const float half = static_cast<float>(random.between(5, 60));
    shot.scene.bounds = {glm::vec3(-half, -1, -half), glm::vec3(half, half * 0.5f, half)};
    shot.camera.fov_y_rad = static_cast<float>(random.between(0.4, 1.4));
    const glm::vec3 eye = glm::vec3(random.direction()) * static_cast<float>(random.between(0, half));
    shot.camera.transform = random.turned(eye);
    return shot;
}

// Returns the position of a world point in shadow map i, in texels, computed with the matrix that shaders
// use.
glm::dvec2 texels_of(const render::SunCascades& sun, uint32_t i, const glm::vec3& point) {
    const glm::dvec4 place = glm::dmat4(sun.constants.cascades[i].world_to_map) * glm::dvec4(point, 1);
    return glm::dvec2(place) * static_cast<double>(kMaps.size_px[i]);
}

double off_whole(double x) {
    return std::abs(x - std::round(x));
}

// Moves the camera by random steps of 0.1 mm (less than a texel) to 10 m (many texels), and rotates it at
// random. A fixed world point must move by a whole number of texels in each shadow map.
TEST(SunCascades, MoveByWholeTexelsHoweverTheCameraMoves) {
    const uint32_t seed = std::random_device{}();
    Random random(seed);
    double worst = 0, farthest_m = 0;
    size_t moved = 0;
    for (int run = 0; run < 200; ++run) {
        Shot shot = random_shot(random);
        const render::SunCascades before = render::sun_cascades(shot.camera, kAspect, shot.scene, kMaps);
        const double step_m = std::pow(10, random.between(-4, 1));
        const glm::vec3 eye =
            glm::vec3(shot.camera.transform[3]) + random.direction() * static_cast<float>(step_m);
        shot.camera.transform = random.turned(eye);
        const render::SunCascades after = render::sun_cascades(shot.camera, kAspect, shot.scene, kMaps);
        for (uint32_t i = 0; i < kMaps.count; ++i) {
            EXPECT_EQ(before.cascades[i].texel_m, after.cascades[i].texel_m);
            EXPECT_EQ(before.cascades[i].radius_m, after.cascades[i].radius_m);
            moved += before.cascades[i].origin_texels != after.cascades[i].origin_texels ? 1 : 0;
            for (int k = 0; k < 20; ++k) {
                const glm::vec3 point = random.direction() * static_cast<float>(random.between(0, 60));
                const glm::dvec2 shift = texels_of(after, i, point) - texels_of(before, i, point);
                worst = std::max({worst, off_whole(shift.x), off_whole(shift.y)});
                farthest_m = std::max(farthest_m, double{glm::length(point)});
            }
        }
    }
    std::printf("seed %u: 200 moves, %zu of %u maps moved, at most %.1e of a texel off a whole number\n",
                seed, moved, 200 * kMaps.count, worst);
    EXPECT_LE(worst, 1e-3) << "seed " << seed;
    EXPECT_GT(moved, 200u) << "what never moves proves nothing; seed " << seed;
}

TEST(SunCascades, HoldWhatTheCameraSeesAndAllThatCasts) {
    const uint32_t seed = std::random_device{}();
    Random random(seed);
    SCOPED_TRACE("seed " + std::to_string(seed));
    for (int run = 0; run < 100; ++run) {
        const Shot shot = random_shot(random);
        const render::SunCascades sun = render::sun_cascades(shot.camera, kAspect, shot.scene, kMaps);
        const double tan_y = std::tan(double{shot.camera.fov_y_rad} / 2);
        for (int k = 0; k < 200; ++k) {
            const glm::dvec3 ray(random.between(-1, 1) * tan_y * kAspect, random.between(-1, 1) * tan_y, -1);
            const double distance_m = random.between(0, 80);
            const glm::dvec4 point =
                glm::dmat4(shot.camera.transform) * glm::dvec4(glm::normalize(ray) * distance_m, 1);
            // Only points inside the scene's bounds are tested. The clamping moves points that are outside,
            // so these are recognised and skipped.
            const glm::dvec3 at = glm::clamp(glm::dvec3(point), glm::dvec3(shot.scene.bounds.min),
                                             glm::dvec3(shot.scene.bounds.max));
            if (glm::length(at - glm::dvec3(point)) > 0) continue;
            uint32_t i = 0;
            while (distance_m > sun.cascades[i].end_m) ++i;
            ASSERT_LT(i, sun.count);
            const glm::dvec2 texels = texels_of(sun, i, glm::vec3(at));
            const double depth = (glm::dmat4(sun.constants.cascades[i].world_to_map) * glm::dvec4(at, 1)).z;
            for (const double t : {texels.x, texels.y}) {
                EXPECT_GE(t, 5);
                EXPECT_LE(t, kMaps.size_px[i] - 5.0);
            }
            EXPECT_GE(depth, 0);
            EXPECT_LE(depth, 1);
        }
    }
}

TEST(SunCascades, AreSeenFromTheSun) {
    Shot shot;
    shot.scene = {glm::normalize(glm::vec3(0.3f, 0.8f, 0.4f)), {glm::vec3(-9), glm::vec3(9)}};
    const render::SunCascades sun = render::sun_cascades(shot.camera, kAspect, shot.scene, kMaps);
    for (uint32_t i = 0; i < sun.count; ++i) {
        const glm::vec4 point(1.5f, -0.25f, 2, 1);
        const glm::vec4 place = sun.constants.cascades[i].world_to_map * point;
        const glm::vec4 clip = sun.views[i].view_projection * point;
        EXPECT_NEAR(clip.x, place.x * 2 - 1, 1e-5);
        EXPECT_NEAR(clip.y, place.y * 2 - 1, 1e-5);
        EXPECT_NEAR(clip.z, place.z, 1e-6);
        EXPECT_EQ(clip.w, 1);
        const glm::vec4 again = sun.views[i].projection * (sun.views[i].view * point);
        EXPECT_NEAR(glm::length(again - clip), 0, 1e-4);
        const glm::vec4 back = sun.views[i].inverse_view_projection * clip;
        EXPECT_NEAR(glm::length(back - point), 0, 1e-4);
        // A point one metre closer to the sun must have the same position in the map, and a depth that is
        // greater by one metre (the depth range 0 to 1 is depth_m metres).
        const glm::vec4 nearer =
            sun.constants.cascades[i].world_to_map * (point + glm::vec4(shot.scene.to_sun, 0));
        EXPECT_NEAR(glm::length(glm::vec2(nearer - place)), 0, 1e-5);
        EXPECT_NEAR((nearer.z - place.z) * sun.constants.cascades[i].depth_m, 1, 1e-3);
    }
}

TEST(SunCascades, EndBetweenEqualRatiosAndEqualSteps) {
    const auto ends_m = render::split_distances(1, 64, 3);
    EXPECT_NEAR(ends_m[0], 0.6 * 4 + 0.4 * 22, 1e-9);
    EXPECT_NEAR(ends_m[1], 0.6 * 16 + 0.4 * 43, 1e-9);
    EXPECT_NEAR(ends_m[2], 64, 1e-9);
}

TEST(SunCascades, OfASceneWithoutEndEndAtTheirReach) {
    Shot shot;
    shot.scene.bounds = {glm::vec3(-5000, 0, -5000), glm::vec3(5000, 100, 5000)};
    const render::SunCascades far = render::sun_cascades(shot.camera, kAspect, shot.scene, kMaps);
    EXPECT_EQ(far.cascades[2].end_m, 250);
    EXPECT_LT(far.cascades[2].radius_m, 250);
    shot.scene.bounds = {};
    const render::SunCascades empty = render::sun_cascades(shot.camera, kAspect, shot.scene, kMaps);
    for (uint32_t i = 0; i < 3; ++i)
        EXPECT_TRUE(std::isfinite(empty.constants.cascades[i].world_to_map[3][2]));
}

}  // namespace
}  // namespace weft::test
