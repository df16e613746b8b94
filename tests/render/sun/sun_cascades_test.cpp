// Tests the positions, ranges and matrices of the sun's shadow maps, mostly with random cameras.
#include "render/views/sun_cascades.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <functional>
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
// Moves the camera by random steps of 0.1 mm to 10 m, and rotates it at random. A fixed world point must move
// by a whole number of texels in each shadow map whose texels stay the same.
TEST(SunCascades, MoveByWholeTexelsHoweverTheCameraMoves) {
    const uint32_t seed = std::random_device{}();
    Random random(seed);
    double worst = 0;
    size_t moved = 0, same = 0;
    for (int run = 0; run < 200; ++run) {
        Shot shot = random_shot(random);
        shot.scene.unknown = shot.scene.bounds;
        const render::SunCascades before = render::sun_cascades(shot.camera, kAspect, shot.scene, kMaps);
        const double step_m = std::pow(10, random.between(-4, 1));
        const glm::vec3 eye =
            glm::vec3(shot.camera.transform[3]) + random.direction() * static_cast<float>(step_m);
        shot.camera.transform = run % 2 == 0 ? random.turned(eye) : shot.camera.transform;
        shot.camera.transform[3] = glm::vec4(eye, 1);
        const render::SunCascades after = render::sun_cascades(shot.camera, kAspect, shot.scene, kMaps);
        for (uint32_t i = 0; i < kMaps.count; ++i) {
            if (before.cascades[i].texel_m != after.cascades[i].texel_m) continue;
            ++same;
            moved += before.cascades[i].origin_texels != after.cascades[i].origin_texels ? 1 : 0;
            for (int k = 0; k < 20; ++k) {
                const glm::vec3 point = random.direction() * static_cast<float>(random.between(0, 60));
                const glm::dvec2 shift = texels_of(after, i, point) - texels_of(before, i, point);
                worst = std::max({worst, off_whole(shift.x), off_whole(shift.y)});
            }
        }
    }
    std::printf(
        "seed %u: of 600 maps, %zu keep their texels and %zu of these move, at most %.1e of a texel off a "
        "whole "
        "number\n",
        seed, same, moved, worst);
    EXPECT_LE(worst, 1e-3) << "seed " << seed;
    EXPECT_GT(same, 100u) << "seed " << seed;
    EXPECT_GT(moved, 4u) << "what never moves proves nothing; seed " << seed;
}

// The texels have few sizes: powers of 2^(1/4).
TEST(SunCascades, HaveTexelsOfFewSizes) {
    Random random(1);
    for (int run = 0; run < 50; ++run) {
        const Shot shot = random_shot(random);
        const render::SunCascades sun = render::sun_cascades(shot.camera, kAspect, shot.scene, kMaps);
        for (uint32_t i = 0; i < kMaps.count; ++i) {
            const glm::dvec2 texel_m = sun.cascades[i].texel_m;
            for (const double side_m : {texel_m.x, texel_m.y})
                EXPECT_LE(off_whole(std::log2(side_m) * 4), 1e-6);
            EXPECT_LE(std::max(texel_m.x / texel_m.y, texel_m.y / texel_m.x), 4 + 1e-9);
        }
    }
}

// While the camera moves by less than the steps of rounded_camera(), nothing changes.
TEST(SunCascades, StayTheSameForCamerasThatAreClose) {
    Shot shot;
    shot.scene = {glm::normalize(glm::vec3(0.3f, 0.8f, 0.4f)), {glm::vec3(-20), glm::vec3(20)}, {}, {}};
    shot.scene.unknown = shot.scene.bounds;
    shot.camera.transform = glm::translate(glm::mat4(1), glm::vec3(0.51f, 1.02f, 3.26f));
    const render::SunCascades before = render::sun_cascades(shot.camera, kAspect, shot.scene, kMaps);
    shot.camera.transform[3] += glm::vec4(-0.05f, 0.04f, 0.06f, 0);
    const render::SunCascades after = render::sun_cascades(shot.camera, kAspect, shot.scene, kMaps);
    shot.camera.transform[3] += glm::vec4(-2.05f, 0, 3.06f, 0);
    const render::SunCascades away = render::sun_cascades(shot.camera, kAspect, shot.scene, kMaps);
    for (uint32_t i = 0; i + 1 < kMaps.count; ++i) {
        EXPECT_EQ(before.constants.cascades[i].world_to_map, after.constants.cascades[i].world_to_map);
        EXPECT_NE(before.constants.cascades[i].world_to_map, away.constants.cascades[i].world_to_map);
    }
}

TEST(SunCascades, HoldWhatTheCameraSeesAndAllThatCasts) {
    const uint32_t seed = std::random_device{}();
    Random random(seed);
    SCOPED_TRACE("seed " + std::to_string(seed));
    for (int run = 0; run < 100; ++run) {
        Shot shot = random_shot(random);
        if (run % 2 == 0) shot.scene.unknown = shot.scene.bounds;
        const render::SunCascades sun = render::sun_cascades(shot.camera, kAspect, shot.scene, kMaps);
        for (int k = 0; k < 200; ++k) {
            glm::vec3 at;
            for (int axis = 0; axis < 3; ++axis)
                at[axis] = static_cast<float>(
                    random.between(double{shot.scene.bounds.min[axis]}, double{shot.scene.bounds.max[axis]}));
            bool is_inside = false;
            for (uint32_t i = 0; i < sun.count; ++i) {
                const glm::dvec2 texels = texels_of(sun, i, at);
                const double size = kMaps.size_px[i] - 7.0;
                is_inside |= texels.x >= 7 && texels.y >= 7 && texels.x <= size && texels.y <= size;
                const double depth =
                    (glm::dmat4(sun.constants.cascades[i].world_to_map) * glm::dvec4(at, 1)).z;
                EXPECT_GE(depth, 0);
                EXPECT_LE(depth, 1);
            }
            EXPECT_TRUE(is_inside) << at.x << " " << at.y << " " << at.z;
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

TEST(SunCascades, OfALargeSceneEndAtTheirReach) {
    Shot shot;
    shot.scene.bounds = {glm::vec3(-5000, 0, -5000), glm::vec3(5000, 100, 5000)};
    shot.scene.unknown = shot.scene.bounds;
    const render::SunCascades far = render::sun_cascades(shot.camera, kAspect, shot.scene, kMaps);
    EXPECT_EQ(far.constants.cascades[0].end_m, 250);
    EXPECT_LE(far.cascades[2].rect.size().x, 501);
    EXPECT_GE(far.cascades[2].rect.size().x, 500);
    EXPECT_LT(far.cascades[0].texel_m.x * far.cascades[0].texel_m.y,
              0.01 * far.cascades[2].texel_m.x * far.cascades[2].texel_m.y);
    shot.scene.bounds = {};
    shot.scene.unknown.reset();
    const render::SunCascades empty = render::sun_cascades(shot.camera, kAspect, shot.scene, kMaps);
    for (uint32_t i = 0; i < 3; ++i)
        EXPECT_TRUE(std::isfinite(empty.constants.cascades[i].world_to_map[3][2]));
}

// Nothing is known about a draw list without bounds. Its shadows reach as far as those of a large scene.
TEST(SunCascades, OfObjectsThatMayBeAnywhereFollowTheCamera) {
    Shot shot;
    shot.scene.is_unbounded = true;
    shot.camera.transform = glm::translate(glm::mat4(1), glm::vec3(1000, 20, -3000));
    const render::SunCascades sun = render::sun_cascades(shot.camera, kAspect, shot.scene, kMaps);
    EXPECT_EQ(sun.constants.cascades[0].end_m, 250);
    for (const double distance_m : {0.5, 5.0, 50.0, 200.0}) {
        const glm::vec3 point = glm::vec3(1000, 20, -3000 - distance_m);
        uint32_t i = 0;
        for (glm::dvec2 at; i < sun.count; ++i) {
            at = texels_of(sun, i, point);
            if (at.x >= 8 && at.y >= 8 && at.x <= 1016 && at.y <= 1016) break;
        }
        ASSERT_LT(i, sun.count) << distance_m;
        EXPECT_LE(std::max(sun.cascades[i].texel_m.x, sun.cascades[i].texel_m.y), 0.6) << distance_m;
        if (distance_m <= 5) {
            EXPECT_LE(sun.cascades[i].texel_m.x, 0.1) << distance_m;
        }
    }
}

// The cache gives what sun_cascades() gives, whatever changes.
TEST(SunCascades, AreComputedAgainWhenAnythingChanges) {
    Random random(5);
    Shot shot = random_shot(random);
    render::SunCascadesCache cache;
    render::SunMaps maps = kMaps;
    float aspect = kAspect;
    uint64_t version = 0;
    render::SurfaceTree wall;
    const std::vector<std::function<void()>> changes{
        [&] { shot.camera.transform[3].x += 3; },
        [&] { shot.scene.unknown = shot.scene.bounds; },
        [&] { shot.camera.fov_y_rad *= 0.5f; },
        [&] { aspect = 1; },
        [&] { shot.scene.to_sun = random.direction(); },
        [&] { shot.scene.bounds.max *= 2.0f; },
        [&] { maps.size_px[1] = 512; },
        [&] { maps.count = 2; },
        [&] {
            const glm::vec3 ahead =
                glm::vec3(shot.camera.transform[3]) - 5.0f * glm::vec3(shot.camera.transform[2]);
            wall = render::SurfaceTree(std::vector{scene::Bounds{ahead - 1.0f, ahead + 1.0f}});
            shot.scene.surfaces = {&wall}, ++version;
        },
        [&] { shot.scene.is_unbounded = true; },
    };
    std::optional<shared::SunConstants> before;
    for (size_t i = 0; i < changes.size(); ++i) {
        changes[i]();
        const render::SunCascades& cached = cache.find(shot.camera, aspect, shot.scene, maps, version);
        const render::SunCascades fresh = render::sun_cascades(shot.camera, aspect, shot.scene, maps);
        EXPECT_EQ(std::memcmp(&cached.constants, &fresh.constants, sizeof fresh.constants), 0) << i;
        EXPECT_TRUE(!before || std::memcmp(&*before, &fresh.constants, sizeof fresh.constants) != 0) << i;
        before = fresh.constants;
    }
}

}  // namespace
}  // namespace weft::test
