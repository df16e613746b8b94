// Tests faults that are known from other implementations of screen-space reflections, and unusual sizes of
// the picture.
#include <algorithm>

#include "tests/render/reflections/reflection_fixture.h"

namespace weft::test {
namespace {

class ReflectionFaults : public ReflectionTest {
 protected:
    static constexpr Extent3D kFaultSize{160, 90, 1};
    static bool is_not_finite(const glm::vec4& x) {
        return glm::any(glm::isnan(x)) || glm::any(glm::isinf(x));
    }
};

// A mirror behind a thin panel must show the back of the panel, which the picture does not show. The front is
// red.
TEST_F(ReflectionFaults, AMirrorBehindAPanelDoesNotShowItsFront) {
    scene::Scene scene;
    scene.sky_zenith = scene.sky_horizon = glm::vec3(0.2f);
    add_box(scene, {-3, 0, -3.1f}, {3, 3, -3}, metal(0));
    add_box(scene, {-0.6f, 0.4f, -1}, {0.6f, 1.4f, -0.99f}, emitter({0, 0, 1}));
    add_box(scene, {-0.6f, 0.4f, -0.99f}, {0.6f, 1.4f, -0.98f}, emitter({1, 0, 0}));
    const LastFrame last = draw(scene, scene::camera_looking_at({1.6f, 1.6f, 2.5f}, {0, 1, -1}, 0.9f),
                                kFaultSize, 8, {"hdr", "depth"});
    size_t mirrors = 0;
    float most = 0;
    for (uint32_t y = 0; y < kFaultSize.height; ++y) {
        for (uint32_t x = 0; x < kFaultSize.width; ++x) {
            const size_t at = size_t(y) * kFaultSize.width + x;
            const float depth = last.images.at("depth")[at].r;
            if (depth <= 0 || std::abs(place_at(last.view, int(x), int(y), depth).z + 3) > 0.01f) continue;
            ++mirrors;
            const glm::vec4 light = last.images.at("hdr")[at] / last.pre_exposure;
            most = std::max(most, light.r - light.g);
        }
    }
    std::printf("%zu pixels of the mirror, at most %.4f red\n", mirrors, double(most));
    EXPECT_GT(mirrors, size_t{2000});
    EXPECT_LE(most, 0.02f);
}

// The mean over frames goes on where the mirrored light is black.
TEST_F(ReflectionFaults, BlackLightKeepsItsHistory) {
    scene::Scene scene;
    scene.sky_zenith = scene.sky_horizon = glm::vec3(0.2f);
    add_box(scene, {-3, -0.1f, -3}, {3, 0, 3}, metal(0.1f));
    add_box(scene, {-2, 0, -1.2f}, {2, 1.5f, -1}, emitter(glm::vec3(0)));
    const LastFrame last = draw(scene, scene::camera_looking_at({0, 1.2f, 2.6f}, {0, 0.3f, -1}, 0.8f),
                                kFaultSize, 12, {"ssr.layer(0)", "ssr.layer(1)"});
    size_t black = 0, kept = 0;
    for (size_t i = 0; i < last.images.at("ssr.layer(0)").size(); ++i) {
        const glm::vec4 light = last.images.at("ssr.layer(0)")[i];
        if (light.a < 0.99f || light.g > 1e-3f) continue;
        ++black;
        kept += last.images.at("ssr.layer(1)")[i].w >= 10;
    }
    std::printf("%zu black texels, %zu of them with at least 10 frames\n", black, kept);
    EXPECT_GT(black, size_t{300});
    EXPECT_GE(double(kept), 0.95 * double(black));
}

TEST_F(ReflectionFaults, AnySizeOfThePictureIsFinite) {
    const Result<scene::Scene> scene = scene::make_builtin("mirror");
    ASSERT_TRUE(scene);
    const std::vector<std::pair<Extent3D, double>> sizes{
        {{1, 1, 1}, 1},   {{1, 1, 1}, 2},   {{1, 9, 1}, 2},    {{9, 1, 1}, 1},
        {{37, 23, 1}, 1}, {{37, 23, 1}, 2}, {{683, 384, 1}, 2}};
    for (const auto& [size, scale] : sizes) {
        params_["ssrScale"] = scale;
        const LastFrame last = draw(*scene, scene->cameras.front(), size, 2, {"hdr", "ssr"});
        for (const auto& [name, texels] : last.images)
            EXPECT_TRUE(std::ranges::none_of(texels, is_not_finite))
                << name << " at " << size.width << " × " << size.height;
    }
}

}  // namespace
}  // namespace weft::test
