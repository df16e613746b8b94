// Tests the matrices of views on the CPU with known points: the faces of a cube, the views of lamps, and
// mirrors.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "render/frame_data.h"
#include "render/views/view_matrices.h"

namespace weft::render {
namespace {

glm::vec4 clip_of(const ViewInput& view, const glm::vec3& p) {
    return view.projection * (view.view * glm::vec4(p, 1));
}

// The uv of a direction on the face of a cube map, from the table of Vulkan: major axis, sc and tc of each
// face.
struct CubePoint {
    uint32_t face = 0;
    glm::vec2 uv{0};
};
CubePoint cube_point(const glm::vec3& r) {
    const glm::vec3 a = glm::abs(r);
    CubePoint point;
    float sc = 0, tc = 0, ma = 0;
    if (a.z >= a.x && a.z >= a.y) {
        point.face = r.z < 0 ? 5 : 4;
        sc = r.z < 0 ? -r.x : r.x, tc = -r.y, ma = a.z;
    } else if (a.y >= a.x) {
        point.face = r.y < 0 ? 3 : 2;
        sc = r.x, tc = r.y < 0 ? -r.z : r.z, ma = a.y;
    } else {
        point.face = r.x < 0 ? 1 : 0;
        sc = r.x < 0 ? r.z : -r.z, tc = -r.y, ma = a.x;
    }
    point.uv = glm::vec2(sc, tc) / ma * 0.5f + 0.5f;
    return point;
}

TEST(ViewMatrices, DrawEachDirectionWhereACubeSamplerReadsIt) {
    std::mt19937 random(71);
    std::uniform_real_distribution<float> number(-1, 1);
    std::array<int, kCubeFaces> met{};
    for (int i = 0; i < 500; ++i) {
        const glm::vec3 direction(number(random), number(random), number(random));
        const glm::vec3 at(number(random) * 10, number(random) * 10, number(random) * 10);
        const CubePoint wanted = cube_point(direction);
        ++met[wanted.face];
        for (uint32_t face = 0; face < kCubeFaces; ++face) {
            const glm::vec4 clip = clip_of(cube_face(at, face, 0.01), at + direction * 20.0f);
            const bool inside = clip.w > 0 && std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w;
            EXPECT_EQ(inside, face == wanted.face) << i;
            if (!inside) continue;
            EXPECT_LT(glm::distance(glm::vec2(clip) / clip.w * 0.5f + 0.5f, wanted.uv), 1e-5f) << i;
            const float major =
                std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)});
            EXPECT_NEAR(clip.z / clip.w, 0.01f / (20 * major), 1e-6f);
        }
    }
    for (const int count : met) EXPECT_GT(count, 30);
}

TEST(ViewMatrices, OfASpotLightContainItsConeAndNoMore) {
    scene::Light light;
    light.type = scene::LightType::spot;
    light.position = {1, 5, -2};
    light.direction = glm::normalize(glm::vec3(1, -2, 0.5f));
    light.inner_cone_rad = 0.2f;
    light.outer_cone_rad = 0.7f;
    for (const glm::vec3& side :
         {glm::vec3(0), glm::normalize(glm::cross(light.direction, glm::vec3(0, 0, 1)))}) {
        light.side = side;
        const std::array lights{gpu_light(light)};
        const std::vector<ViewInput> views = lamp_views(lights);
        ASSERT_EQ(views.size(), 1u);
        const glm::vec4 axis = clip_of(views[0], light.position + light.direction * 3.0f);
        EXPECT_NEAR(axis.x / axis.w, 0, 1e-5f);
        EXPECT_NEAR(axis.y / axis.w, 0, 1e-5f);
        EXPECT_NEAR(axis.w, 3, 1e-4f);
        const glm::vec3 across = glm::normalize(glm::cross(light.direction, glm::vec3(0, 1, 0)));
        const glm::vec3 up = glm::cross(across, light.direction);
        float widest = 0;
        for (int i = 0; i < 64; ++i) {
            const float turn = 0.0981748f * static_cast<float>(i);
            const glm::vec3 rim =
                light.direction + std::tan(0.7f) * (std::cos(turn) * across + std::sin(turn) * up);
            const glm::vec4 clip = clip_of(views[0], light.position + rim);
            EXPECT_NEAR(glm::length(glm::vec2(clip) / clip.w), 1, 1e-3f);
            widest = std::max(widest, std::abs(clip.x / clip.w));
        }
        EXPECT_GT(widest, 0.99f);
        EXPECT_FALSE(is_mirrored(views[0].projection * views[0].view));
    }
}

TEST(ViewMatrices, OfLampsAreInTheOrderOfTheLights) {
    std::vector<shared::Light> lights(5);
    for (shared::Light& light : lights)
        light.direction = {0, 0, -1}, light.cone_scale = 2, light.cone_offset = -1;
    lights[0].type = shared::kLightDirectional;
    lights[1].type = shared::kLightPoint, lights[1].position = {7, 8, 9};
    lights[2].type = shared::kLightRectangle;
    lights[3].type = shared::kLightSpot, lights[3].position = {1, 2, 3};
    lights[4].type = shared::kLightCapsule;
    const std::vector<ViewInput> views = lamp_views(lights);
    ASSERT_EQ(views.size(), 7u);
    uint32_t counted = 0;
    for (const shared::Light& light : lights) counted += count_lamp_views(light);
    EXPECT_EQ(counted, 7u);
    for (uint32_t face = 0; face < kCubeFaces; ++face)
        EXPECT_EQ(views[face].view, cube_face({7, 8, 9}, face, 1).view) << face;
    EXPECT_EQ(constants_of(views[6]).eye, glm::vec3(1, 2, 3));
}

TEST(ViewMatrices, InAMirrorShowPointsWhereTheirImagesAre) {
    scene::Camera camera;
    camera.transform = glm::mat4(1);
    camera.transform[3] = {1, 2, 8, 1};
    const shared::ViewConstants straight = view_constants(camera, glm::mat4(1), 64, 48, {0.25f, -0.5f});
    const std::array<double, 4> plane{0.6, 0.8, 0, -1.5};
    const shared::ViewConstants view = mirrored(straight, plane);
    std::mt19937 random(72);
    std::uniform_real_distribution<float> number(-5, 5);
    const auto reflect = [&](const glm::vec3& p) {
        const glm::vec3 normal(0.6f, 0.8f, 0);
        return p - 2 * (glm::dot(normal, p) - 1.5f) * normal;
    };
    for (int i = 0; i < 100; ++i) {
        const glm::vec3 p(number(random), number(random), number(random));
        const glm::vec4 seen = view.view_projection * glm::vec4(p, 1);
        const glm::vec4 image = straight.view_projection * glm::vec4(reflect(p), 1);
        EXPECT_LT(glm::distance(glm::vec3(seen.x, seen.y, seen.w), glm::vec3(image.x, image.y, image.w)), 1e-4f);
        const glm::vec4 back = view.inverse_view_projection * seen;
        EXPECT_LT(glm::distance(glm::vec3(back) / back.w, p), 1e-3f);
        EXPECT_LT(glm::distance(view.projection * (view.view * glm::vec4(p, 1)), seen), 1e-3f);
    }
    EXPECT_LT(glm::distance(view.eye, reflect(straight.eye)), 1e-5f);
    EXPECT_FALSE(is_mirrored(straight.view_projection));
    EXPECT_TRUE(is_mirrored(view.view_projection));
    EXPECT_FALSE(is_mirrored(mirrored(view, {0, 1, 0, 2}).view_projection)) << "two mirrors";
}

// The eye is on the positive side of the plane.
TEST(ViewMatrices, InAMirrorHaveTheMirrorAsTheirNearPlane) {
    scene::Camera camera;
    camera.transform[3] = {1, 2, 8, 1};
    const shared::ViewConstants straight = view_constants(camera, glm::mat4(1), 64, 48, {0, 0});
    const shared::ViewConstants view = mirrored(straight, {0.6, 0.8, 0, -1.5});
    std::mt19937 random(73);
    std::uniform_real_distribution<float> number(-50, 50);
    int inside = 0, behind = 0;
    for (int i = 0; i < 2000; ++i) {
        const glm::vec3 p(number(random), number(random), number(random));
        const float height = glm::dot(p, glm::vec3(0.6f, 0.8f, 0)) - 1.5f;
        const glm::vec4 clip = view.view_projection * glm::vec4(p, 1);
        if (clip.w <= 0 || std::abs(clip.x) > clip.w || std::abs(clip.y) > clip.w) continue;
        if (std::abs(height) > 0.01f) {
            EXPECT_EQ(clip.z < clip.w, height > 0) << i;
        }
        if (height > 0) {
            EXPECT_GE(clip.z, 0) << i;
        }
        ++(height > 0 ? inside : behind);
        const glm::vec4 on = view.view_projection * glm::vec4(p - height * glm::vec3(0.6f, 0.8f, 0), 1);
        EXPECT_NEAR(on.z, on.w, 1e-3f) << i;
    }
    EXPECT_GT(inside, 20);
    EXPECT_GT(behind, 2);
}

// A triangle that faces the viewer is counter-clockwise in the picture unless the view is mirrored.
TEST(ViewMatrices, TellWhetherTrianglesTurnTheirWinding) {
    std::mt19937 random(73);
    std::uniform_real_distribution<float> number(-1, 1);
    glm::mat4 parallel(1);
    parallel[0][0] = 0.1f, parallel[1][1] = -0.1f, parallel[2][2] = 0.01f, parallel[3][2] = 1;
    int mirrored_ones = 0;
    for (int i = 0; i < 60; ++i) {
        ViewInput view = cube_face({0, 0, 0}, static_cast<uint32_t>(i) % kCubeFaces, 0.01);
        if (i % 3 == 1) view.projection = parallel;
        if (i % 2 == 1) view.projection[0][0] *= -1;
        const glm::mat4 to_clip = view.projection * view.view;
        const glm::mat4 to_world = glm::inverse(view.view);
        const auto world = [&](const glm::vec3& p) { return glm::vec3(to_world * glm::vec4(p, 1)); };
        const glm::vec3 a = world({number(random), number(random), -5}),
                        b = world({number(random), number(random), -5}),
                        c = world({number(random), number(random), -5});
        const glm::vec3 to_eye = world({0, 0, 0}) - a;
        const bool faces_eye = glm::dot(glm::cross(b - a, c - a), to_eye) > 0;
        const auto pixel = [&](const glm::vec3& p) {
            const glm::vec4 clip = to_clip * glm::vec4(p, 1);
            return glm::vec2(clip) / clip.w;
        };
        const glm::vec2 ab = pixel(b) - pixel(a), ac = pixel(c) - pixel(a);
        // y points down, so a negative area is counter-clockwise.
        const bool counter_clockwise = ab.x * ac.y - ab.y * ac.x < 0;
        EXPECT_EQ(is_mirrored(to_clip), counter_clockwise != faces_eye) << i;
        mirrored_ones += is_mirrored(to_clip) ? 1 : 0;
    }
    EXPECT_GT(mirrored_ones, 10);
    EXPECT_LT(mirrored_ones, 50);
}

TEST(ViewMatrices, GiveTheDistanceOfTheNearPlane) {
    EXPECT_FLOAT_EQ(constants_of(cube_face({0, 0, 0}, 2, 0.25)).near_m, 0.25f);
    EXPECT_FLOAT_EQ(constants_of({glm::mat4(1), reversed_infinite_projection(1, 2, 0.5f)}).near_m, 0.5f);
}

}  // namespace
}  // namespace weft::render
