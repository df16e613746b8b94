// Tests the module dfg.json, and pictures with the light of the surroundings.
#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

#include "tests/render/shading/ambient_fixture.h"

namespace weft::test {
namespace {

// Scale and bias of the directional albedo. Source: numerical integration with 2^20 samples.
TEST_F(AmbientLight, TheTableOfTheAlbedoHasTheIntegrals) {
    constexpr std::array kRoughness{10, 30, 50, 80, 100};
    constexpr std::array kCosines{10, 25, 50, 75, 100};
    constexpr double kScale[5][5] = {{.4158, .7629, .9683, .9989, .9999},
                                     {.5630, .7535, .9427, .9847, .9907},
                                     {.7519, .7593, .8349, .8888, .9158},
                                     {.7889, .6952, .6143, .5741, .5551},
                                     {.7363, .5868, .4477, .3639, .3068}};
    constexpr double kBias[5][5] = {{.5784, .2362, .0314, .0010, 0},
                                    {.3214, .1783, .0324, .0018, 0},
                                    {.1397, .0808, .0223, .0027, 0},
                                    {.0442, .0229, .0069, .0014, 0},
                                    {.0239, .0109, .0030, .0006, 0}};
    scene::Scene scene;
    auto found = run(scene, {"albedo", "fitted"});
    ASSERT_EQ(found["albedo"].size(), 10100u);
    double worst = 0, worst_share = 0;
    for (size_t i = 0; i < 5; ++i)
        for (size_t k = 0; k < 5; ++k) {
            const glm::vec4 texel = found["albedo"][size_t(kRoughness[i]) * 100 + size_t(kCosines[k]) - 1];
            for (const auto& [value, expected] :
                 {std::pair(texel.r, kScale[i][k]), std::pair(texel.g, kBias[i][k])}) {
                worst = std::max(worst, std::abs(value - expected));
                if (expected > 0.1) worst_share = std::max(worst_share, std::abs(value / expected - 1));
            }
            EXPECT_NEAR(texel.b * (texel.r + texel.g), 1, 1e-3);
        }
    std::printf("table: largest error %.5f, relative %.5f\n", worst, worst_share);
    EXPECT_LT(worst, 1e-3);
    EXPECT_LT(worst_share, 5e-3);
    glm::dvec2 fit(0);
    for (int r = 0; r <= 100; r += 4)
        for (int c = 2; c <= 100; c += 7) {
            const glm::dvec2 expected = reference_albedo(r / 100.0, c / 100.0);
            const glm::vec4 texel = found["fitted"][size_t(r) * 100 + size_t(c) - 1];
            fit = glm::max(fit, glm::abs(glm::dvec2(texel) - expected));
        }
    std::printf("fit: largest errors %.5f and %.5f\n", fit.x, fit.y);
    EXPECT_LT(fit.x, 0.01);
    EXPECT_LT(fit.y, 0.01);
}

// Every surface of white spheres with all roughnesses reflects all light of a constant environment, so
// the spheres cannot be seen.
TEST_F(AmbientLight, WhiteSpheresVanishInAWhiteFurnace) {
    Result<scene::Scene> scene = scene::make_builtin("spheres");
    ASSERT_TRUE(scene);
    scene->lights.clear();
    scene->environment = picture_of([](const glm::dvec3&) { return 1; }, 32);
    for (size_t i = 0; i < scene->materials.size(); ++i) {
        scene::Material& material = scene->materials[i];
        material.base_color = glm::vec4(1);
        material.metallic = i % 2 == 0 ? 1.0f : 0.0f;
        material.roughness = float(i / 2) / float((scene->materials.size() - 1) / 2);
    }
    for (const char* graph : {"deferred", "forward"}) {
        const Rendered r =
            render(*scene, scene->cameras.at(0), {160, 90, 1}, 0, {"hdr", "depth"}, graph_path(graph));
        ASSERT_EQ(r.images.size(), 2u);
        size_t surfaces = 0;
        for (size_t i = 0; i < r.images.at("hdr").size(); ++i) {
            surfaces += r.images.at("depth")[i].r > 0 ? 1 : 0;
            ASSERT_NEAR(r.images.at("hdr")[i].g, 1, 0.005) << graph << ", pixel " << i;
        }
        EXPECT_GT(surfaces, 3000u);
    }
}

// Reads the module of the table with the light of single reflections only.
std::optional<std::string> read_single_reflections(const std::string& path) {
    std::optional<std::string> text = read_text(path);
    const std::string key = "\"default\": true";
    if (text && path.ends_with("modules/dfg.json"))
        text->replace(text->find(key), key.size(), "\"default\": false");
    return text;
}

TEST_F(AmbientLight, SingleReflectionsLoseTheLightOfTheTable) {
    scene::Scene scene;
    const std::unique_ptr<render::Session> session =
        start(scene, scene::Camera{}, kAmbientGraph, {16, 16, 1}, {"albedo"}, 0, read_single_reflections);
    ASSERT_TRUE(session && draw_frame(*session) && session->finish());
    const std::vector<vk::ReadbackData> read = session->take_readbacks();
    const auto albedo = std::ranges::find(read, "observe:albedo", &vk::ReadbackData::pass);
    ASSERT_TRUE(albedo != read.end());
    for (const glm::vec4& texel : render::decode_texels(albedo->format, albedo->bytes)) ASSERT_EQ(texel.b, 1);
}

// Renders the spheres with an environment, and returns the picture.
class AmbientPicture : public AmbientLight {
 protected:
    std::vector<glm::vec4> spheres(const Surroundings& light, float turn_rad, float exposure_ev) {
        Result<scene::Scene> scene = scene::make_builtin("spheres");
        if (!scene) return {};
        scene->lights.clear();
        scene->environment = picture_of(light);
        for (scene::Material& material : scene->materials) material.metallic = 1;
        const glm::mat4 turn = glm::rotate(glm::mat4(1), turn_rad, glm::vec3(0, 1, 0));
        for (scene::Instance& instance : scene->instances) instance.transform = turn * instance.transform;
        scene::Camera camera = scene->cameras.at(0);
        camera.transform = turn * camera.transform;
        return render(*scene, camera, {160, 90, 1}, exposure_ev, {"hdr"}).images["hdr"];
    }
};

void expect_same(const std::vector<glm::vec4>& a, const std::vector<glm::vec4>& b, double mean_share,
                 double most_share) {
    ASSERT_EQ(a.size(), b.size());
    ASSERT_FALSE(a.empty());
    double sum = 0, most = 0;
    for (size_t i = 0; i < a.size(); ++i) {
        const double share = std::abs(a[i].g - b[i].g) / b[i].g;
        sum += share / double(a.size());
        most = std::max(most, share);
    }
    std::printf("mean difference %.4f %%, largest %.4f %%\n", sum * 100, most * 100);
    EXPECT_LT(sum, mean_share);
    EXPECT_LT(most, most_share);
}

TEST_F(AmbientPicture, ATurnedSceneInATurnedEnvironmentLooksTheSame) {
    const float angle = 37 * float(kPi) / 180;
    const glm::dmat3 back(glm::rotate(glm::dmat4(1), -double(angle), glm::dvec3(0, 1, 0)));
    expect_same(spheres([&](const glm::dvec3& d) { return smooth_sky(back * d); }, angle, 0),
                spheres(smooth_sky, 0, 0), 0.004, 0.1);
}

TEST_F(AmbientPicture, AThousandTimesTheLightWithLessExposureLooksTheSame) {
    expect_same(spheres([](const glm::dvec3& d) { return smooth_sky(d) * 1000; }, 0, -std::log2(1000.0f)),
                spheres(smooth_sky, 0, 0), 0.0005, 0.004);
}

TEST_F(AmbientLight, ThePassesRestFromTheSecondFrameOn) {
    Result<scene::Scene> scene = scene::make_builtin("spheres");
    ASSERT_TRUE(scene);
    const std::unique_ptr<render::Session> session =
        start(*scene, scene->cameras.at(0), kDeferredGraph, {32, 18, 1}, {});
    ASSERT_TRUE(session);
    for (int frame = 0; frame < 3; ++frame) {
        frame_of(*session).exposure_ev = float(frame);  // The cube does not depend on the exposure.
        ASSERT_TRUE(draw_frame(*session, frame, 1));
        ASSERT_TRUE(session->finish());
        size_t found = 0;
        for (const vk::FrameTiming& timing : session->take_timings())
            for (const vk::PassTiming& pass : timing.passes) {
                if (!pass.pass.starts_with("environment") && pass.pass != "dfg") continue;
                ++found;
                EXPECT_EQ(pass.woken_by.empty(), frame > 0) << pass.pass << ", frame " << frame;
            }
        EXPECT_EQ(found, 16u);
    }
}

}  // namespace
}  // namespace weft::test
