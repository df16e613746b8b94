// Tests that objects far in front of a wall leave no halo on the wall. The near field is traced for every
// second pixel, smoothed, blended with earlier frames and laid on all pixels, and each of these steps must
// stop at the outlines.
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "tests/render/shading/ambient_fixture.h"
#include "tests/render/sun/box_outline.h"
#include "weft/render/session.h"

namespace weft::test {
namespace {

constexpr Extent3D kHaloSize{640, 360, 1};
constexpr int kHaloFrames = 12;
constexpr double kMostHaloPx = 2;
constexpr float kWallAway_m = 6, kHalo = 0.01f;  // A halo is a difference of the light of at least 1 %.

// Returns the distance of a pixel of the wall from the nearest pixel that shows an object, in pixels.
template <typename Shows>
double distance_px(const Shows& shows_wall, int x, int y) {
    constexpr int kReach = 12;
    double nearest = kReach;
    for (int dy = -kReach; dy <= kReach; ++dy)
        for (int dx = -kReach; dx <= kReach; ++dx) {
            const int u = x + dx, v = y + dy;
            if (u < 0 || v < 0 || u >= int(kHaloSize.width) || v >= int(kHaloSize.height)) continue;
            if (!shows_wall(u, v)) nearest = std::min(nearest, std::hypot(dx, dy));
        }
    return nearest;
}

class NearHalo : public SessionTest {
 protected:
    // A grey wall 6 m away, and 3 m in front of it two bars and an open box with thin sides, which is dark
    // inside. Objects are near within 1 m.
    static scene::Scene bar_before_wall() {
        scene::Scene scene;
        scene::Material grey;
        grey.base_color = {0.1f, 0.1f, 0.1f, 1};
        grey.metallic = 0;
        grey.specular = 0;
        scene.materials = {grey};
        scene.environment = picture_of([](const glm::dvec3&) { return 1; }, 32);
        const std::vector<std::pair<glm::vec3, glm::vec3>> boxes{{{-9, -9, -7}, {9, 9, -6}},
                                                                 {{-1.2f, -2, -3}, {-1.15f, 2, -2.95f}},
                                                                 {{0.8f, -0.6f, -3.2f}, {0.85f, 0.9f, -2.9f}},
                                                                 {{-0.4f, -0.4f, -3}, {0.3f, 0.3f, -2.9f}},
                                                                 {{-0.41f, -0.4f, -3}, {-0.4f, 0.3f, -2.6f}},
                                                                 {{0.3f, -0.4f, -3}, {0.31f, 0.3f, -2.6f}},
                                                                 {{-0.4f, -0.41f, -3}, {0.3f, -0.4f, -2.6f}},
                                                                 {{-0.4f, 0.3f, -3}, {0.3f, 0.31f, -2.6f}}};
        for (const auto& [least, most] : boxes) {
            scene.instances.push_back({"box", uint32_t(scene.meshes.size()), 0, glm::mat4(1)});
            scene.meshes.push_back(box_mesh(least, most));
        }
        return scene;
    }
};

TEST_F(NearHalo, IsAtMostTwoPixelsWide) {
    scene::Camera camera;
    camera.fov_y_rad = glm::radians(40.0f);
    const auto session = start(bar_before_wall(), camera, graph_path("weft"), kHaloSize, {"depth", "hdr"});
    ASSERT_TRUE(session);
    for (int i = 0; i < kHaloFrames; ++i) ASSERT_TRUE(draw_frame(*session));
    ASSERT_TRUE(session->finish());
    std::vector<glm::vec4> depths, light;
    for (const vk::ReadbackData& data : session->take_readbacks())
        (data.pass == "observe:hdr" ? light : depths) = render::decode_texels(data.format, data.bytes);
    ASSERT_EQ(depths.size(), light.size());
    const float near_m = session->parts().frames.view().near_m;
    const auto shows_wall = [&](int x, int y) {
        return near_m / depths[size_t(y) * kHaloSize.width + size_t(x)].r > kWallAway_m - 0.01f;
    };
    // The corner of the picture is far from all objects.
    ASSERT_TRUE(shows_wall(0, 0));
    double widest = 0;
    size_t compared = 0;
    for (int y = 0; y < int(kHaloSize.height); ++y) {
        for (int x = 0; x < int(kHaloSize.width); ++x) {
            if (!shows_wall(x, y)) continue;
            ++compared;
            const float here = light[size_t(y) * kHaloSize.width + size_t(x)].g;
            if (std::abs(here / light[0].g - 1) < kHalo) continue;
            widest = std::max(widest, distance_px(shows_wall, x, y));
        }
    }
    std::printf("%zu pixels of the wall, halos up to %.1f pixels wide\n", compared, widest);
    EXPECT_GT(compared, size_t{kHaloSize.width} * kHaloSize.height / 2);
    EXPECT_LE(widest, kMostHaloPx);
}

}  // namespace
}  // namespace weft::test
