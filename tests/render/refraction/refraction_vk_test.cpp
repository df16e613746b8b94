// Tests that a body of water bends and absorbs the light of what lies in it, against rays that this file
// follows through the surface of the water (Snell's law, law of Beer and Lambert).
#include <algorithm>
#include <cmath>

#include "tests/render/reflections/reflection_fixture.h"
#include "tests/render/shading/ambient_fixture.h"

namespace weft::test {
namespace {

constexpr Extent3D kWaterSize{320, 180, 1};
constexpr float kStripe_m = 0.25f;
constexpr int kStripes = 12;
constexpr float kDepth_m = 0.4f, kIor = 1.33f;
const glm::vec3 kAbsorption_per_m{1.2f, 0.4f, 0.3f};
const glm::vec3 kEye{0.2f, 1.1f, 2.3f};

glm::vec3 stripe_color(int stripe) {
    return stripe % 2 == 0 ? glm::vec3(0.9f, 0.6f, 0.3f) : glm::vec3(0.2f, 0.3f, 0.5f);
}

// Water without mirrored light.
scene::Material water(float thickness_m, float specular = 0) {
    scene::Material material;
    material.metallic = 0;
    material.roughness = 0;
    material.specular = specular;
    material.ior = kIor;
    material.alpha_mode = scene::AlphaMode::blend;
    material.transmission = 1;
    material.thickness_m = thickness_m;
    material.absorption_per_m = kAbsorption_per_m;
    return material;
}

// A flat floor at y = −kDepth_m with stripes along z that emit light. Its stripes reach beyond the picture.
scene::Scene striped_floor() {
    scene::Scene scene;
    scene.sky_zenith = scene.sky_horizon = glm::vec3(0);
    for (int i = -kStripes; i < kStripes; ++i) {
        const float x = kStripe_m * float(i);
        add_box(scene, {x, -kDepth_m - 0.1f, -9}, {x + kStripe_m, -kDepth_m, 3},
                emitter(stripe_color(i + kStripes)));
    }
    return scene;
}

void add_water(scene::Scene& scene, const scene::Material& material, float half_x_m = 3) {
    add_box(scene, {-half_x_m, -0.001f, -4}, {half_x_m, 0, 2}, material);
}

// The stripe that the eye sees through a place of the surface, and its light.
struct Through {
    int stripe = 0;
    glm::vec3 light{0};
};

Through look_through(const glm::vec3& at) {
    const glm::vec3 way = glm::refract(glm::normalize(at - kEye), glm::vec3(0, 1, 0), 1 / kIor);
    const float length_m = kDepth_m / -way.y;
    const int stripe = int(std::floor((at.x + way.x * length_m) / kStripe_m)) + kStripes;
    return {stripe, stripe_color(stripe) * glm::exp(-kAbsorption_per_m * length_m)};
}

class Refraction : public ReflectionTest {
 protected:
    LastFrame look_at_water(const scene::Scene& scene, const std::string& graph = kDeferredGraph) {
        return draw(scene, scene::camera_looking_at(kEye, {0, 0, -0.4f}, 0.7f), kWaterSize, 1,
                    {"hdr", "depth"}, graph);
    }
    static glm::vec3 light_at(const LastFrame& last, int x, int y) {
        EXPECT_TRUE(std::isfinite(last.images.at("hdr")[size_t(y) * kWaterSize.width + size_t(x)].g));
        return glm::vec3(last.images.at("hdr")[size_t(y) * kWaterSize.width + size_t(x)]) / last.pre_exposure;
    }
    // The place of the plane y = 0 in the middle of a pixel.
    static glm::vec3 on_water(const LastFrame& last, int x, int y) {
        const glm::vec3 through = place_at(last.view, x, y, 0.5f);
        const glm::vec3 way = through - kEye;
        return kEye + way * (-kEye.y / way.y);
    }
    // Returns the share of pixels whose light differs by more than 2 %. Pixels near the edge of a stripe do
    // not count, because light is interpolated there.
    static double share_of_others(const LastFrame& last) {
        int others = 0, count = 0;
        for (int y = 50; y < 150; y += 3) {
            for (int x = 20; x < 300; ++x) {
                const Through expected = look_through(on_water(last, x, y));
                if (look_through(on_water(last, x - 2, y)).stripe != expected.stripe) continue;
                if (look_through(on_water(last, x + 2, y)).stripe != expected.stripe) continue;
                const glm::vec3 apart = glm::abs(light_at(last, x, y) - expected.light);
                ++count;
                if (std::max({apart.r, apart.g, apart.b}) > 0.02f * expected.light.g) ++others;
            }
        }
        return double(others) / count;
    }
};

TEST_F(Refraction, BendsAndAbsorbsLikeARay) {
    for (const char* graph : {"deferred", "forward", "light_indexed"}) {
        scene::Scene scene = striped_floor();
        add_water(scene, water(2));
        const double others = share_of_others(look_at_water(scene, graph_path(graph)));
        std::printf("%s: %.2f %% of the pixels differ from the ray\n", graph, 100 * others);
        EXPECT_LE(others, 0.01);
    }
    // The straight view is another picture, so the comparison can fail.
    scene::Scene straight = striped_floor();
    add_water(straight, water(0));
    EXPECT_GE(share_of_others(look_at_water(straight)), 0.5);
}

// A body of half the thickness absorbs as if the floor was in the middle of the water.
TEST_F(Refraction, EndsWithTheThickness) {
    scene::Scene scene = striped_floor();
    add_water(scene, water(kDepth_m / 2));
    const LastFrame last = look_at_water(scene);
    int same = 0, count = 0;
    for (int x = 20; x < 300; ++x) {
        const glm::vec3 at = on_water(last, x, 120);
        const glm::vec3 way = glm::refract(glm::normalize(at - kEye), glm::vec3(0, 1, 0), 1 / kIor);
        const glm::vec3 passed = glm::exp(-kAbsorption_per_m * (kDepth_m / 2 / -way.y));
        const glm::vec3 light = light_at(last, x, 120) / passed;
        ++count;
        for (int stripe : {0, 1})
            if (glm::distance(light, stripe_color(stripe)) < 0.02f) ++same;
    }
    EXPECT_GE(double(same) / count, 0.9);
}

// At the edge of the water, the floor rises above it. Where the depth is 0, the light is that of the floor.
TEST_F(Refraction, HasNoSeamAtTheShore) {
    scene::Scene scene;
    scene.sky_zenith = scene.sky_horizon = glm::vec3(0);
    add_box(scene, {-6, -0.1f, -8}, {6, 0, 2}, emitter(glm::vec3(0.5f)));
    // The floor falls by 1 m in 10 m, towards −z.
    scene.instances.back().transform = glm::rotate(glm::mat4(1), -0.1f, glm::vec3(1, 0, 0));
    add_water(scene, water(2));
    const LastFrame last = look_at_water(scene);
    float steepest = 0, darkest = 1;
    for (int x = 40; x < 280; x += 20) {
        for (int y = 60; y < 170; ++y) {
            const float here = light_at(last, x, y).r, next = light_at(last, x, y + 1).r;
            steepest = std::max(steepest, std::abs(here - next));
            darkest = std::min(darkest, here);
        }
    }
    std::printf("largest step between pixels %.4f, darkest pixel %.3f\n", double(steepest), double(darkest));
    EXPECT_LE(steepest, 0.01f);
    EXPECT_LE(darkest, 0.45f);
}

// A box floats above the water. The water shows nothing of the box at places where the eye sees the floor.
TEST_F(Refraction, ShowsNothingThatIsInFrontOfTheWater) {
    scene::Scene scene;
    scene.sky_zenith = scene.sky_horizon = glm::vec3(0);
    add_box(scene, {-3, -kDepth_m - 0.1f, -4}, {3, -kDepth_m, 3}, emitter({0, 0.5f, 0}));
    add_box(scene, {-0.2f, 0.05f, 0.2f}, {0.2f, 0.4f, 0.5f}, emitter({1, 0, 0}));
    scene::Material rough = water(2);
    rough.absorption_per_m = glm::vec3(0);
    add_water(scene, rough);
    const LastFrame last = look_at_water(scene);
    int reds = 0;
    for (int y = 0; y < int(kWaterSize.height); ++y) {
        for (int x = 0; x < int(kWaterSize.width); ++x) {
            const float depth = last.images.at("depth")[size_t(y) * kWaterSize.width + size_t(x)].r;
            const bool floor = depth > 0 && place_at(last.view, x, y, depth).y < -0.5f * kDepth_m;
            if (floor && light_at(last, x, y).r > 0.01f) ++reds;
        }
    }
    std::printf("%d pixels of the floor show the box\n", reds);
    // Devices round the place between texels differently in textureGather() and in the filter.
    EXPECT_LE(reds, 2);
}

// Uniform light stays uniform: the surface mirrors a part of it and lets the rest pass.
TEST_F(Refraction, NeitherAddsNorLosesLight) {
    scene::Scene scene;
    scene.environment = picture_of([](const glm::dvec3&) { return 1; }, 32);
    add_box(scene, {-3, -kDepth_m - 0.1f, -4}, {3, -kDepth_m, 3}, emitter(glm::vec3(1)));
    scene::Material clear = water(2, 1);
    clear.absorption_per_m = glm::vec3(0);
    add_water(scene, clear);
    const LastFrame last = look_at_water(scene);
    float least = 10, most = 0;
    for (int y = 30; y < 175; ++y) {
        for (int x = 10; x < 310; ++x) {
            least = std::min(least, light_at(last, x, y).g);
            most = std::max(most, light_at(last, x, y).g);
        }
    }
    std::printf("radiance %.4f to %.4f\n", double(least), double(most));
    EXPECT_GE(least, 0.99f);
    EXPECT_LE(most, 1.01f);
}

// Ripples move with the time, and have the same picture at the same time.
TEST_F(Refraction, RipplesMove) {
    scene::Scene scene = striped_floor();
    scene::Texture bumps{"bumps", 2, 2, scene::ColorSpace::linear, {}};
    bumps.mips = {{108, 128, 254, 255, 148, 128, 254, 255, 128, 108, 254, 255, 128, 148, 254, 255}};
    scene.textures.push_back(bumps);
    scene::Material rippled = water(2);
    rippled.normal_texture.texture = 0;
    rippled.ripples = {0.3f, 0.1f, -0.1f, 0.3f};
    add_water(scene, rippled);
    const std::unique_ptr<render::Session> session = start(
        scene, scene::camera_looking_at(kEye, {0, 0, -0.4f}, 0.7f), kDeferredGraph, kWaterSize, {"hdr"});
    ASSERT_TRUE(session);
    frame_of(*session).parameters["autoExposure"] = 0;
    std::vector<std::vector<glm::vec4>> frames;
    for (const double time_s : {0.0, 0.5, 0.0}) {
        ASSERT_TRUE(draw_frame(*session, time_s) && session->finish());
        for (const vk::ReadbackData& data : session->take_readbacks())
            frames.push_back(render::decode_texels(data.format, data.bytes));
    }
    ASSERT_EQ(frames.size(), 3u);
    EXPECT_EQ(frames[0], frames[2]);
    EXPECT_NE(frames[0], frames[1]);
}

}  // namespace
}  // namespace weft::test
