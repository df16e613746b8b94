// Tests that the lamps of builtin:atrium, whose intensities are fixed, add little to surfaces in the sun at
// noon.
#include <algorithm>

#include "tests/render/session_fixture.h"
#include "tests/render/shading/reference_light.h"

namespace weft::test {
namespace {

constexpr Extent3D kNoonSize{192, 108, 1};
constexpr double kWhite = 0.5;       // Albedo of all surfaces in this test.
constexpr double kSunlit_lx = 2400;  // A tenth of the sun's illuminance at noon.
constexpr double kBesideLamp_m =
    0.5;  // Nearer points are not counted: the body of a lamp, and what touches it.
constexpr float kNoonExposure_ev = -8;

// The court at noon under a black sky, with the lamps of the night. All surfaces are matt, so that the
// picture shows illuminances.
Result<scene::Scene> lamps_at_noon() {
    scene::BuiltinOptions noon, night;
    noon.hour = 12.0f;
    night.hour = 22.0f;
    Result<scene::Scene> scene = scene::make_builtin("atrium", noon);
    Result<scene::Scene> dark = scene::make_builtin("atrium", night);
    if (!scene || !dark) return scene;
    scene->sky_zenith = scene->sky_horizon = glm::vec3(0);
    for (size_t i = 1; i < scene->lights.size(); ++i) {
        const float now = scene->lights[i].intensity;
        EXPECT_TRUE(now == 0 || now == dark->lights[i].intensity) << scene->lights[i].name;
        scene->lights[i].intensity = dark->lights[i].intensity;
    }
    for (scene::Material& material : scene->materials) {
        scene::Material matt;
        matt.base_color = glm::vec4(glm::vec3(float(kWhite)), material.base_color.a);
        matt.metallic = matt.specular = 0;
        matt.alpha_mode = material.alpha_mode;
        matt.double_sided = material.double_sided;
        material = matt;
    }
    return scene;
}

class NoonLamps : public SessionTest {
 protected:
    // Renders one frame and returns the luminances before transparent surfaces are drawn.
    std::vector<glm::vec4> frame(render::Session& session, const std::vector<scene::Light>& lights) {
        frame_of(session).lights = lights;
        EXPECT_TRUE(draw_frame(session) && session.finish());
        std::vector<glm::vec4> light;
        for (const vk::ReadbackData& data : session.take_readbacks()) {
            std::vector<glm::vec4> texels = render::decode_texels(data.format, data.bytes);
            (data.pass == "observe:depth" ? depth_ : light) = std::move(texels);
        }
        return light;
    }
    std::vector<glm::vec4> depth_;
};

double distance_to_lamps(const glm::dvec3& point, const std::vector<scene::Light>& lights) {
    double least = std::numeric_limits<double>::max();
    for (size_t i = 1; i < lights.size(); ++i)
        least = std::min(least, glm::distance(point, glm::dvec3(lights[i].position)));
    return least;
}

TEST_F(NoonLamps, AddLittleToEachSunlitSurface) {
    const Result<scene::Scene> scene = lamps_at_noon();
    ASSERT_TRUE(scene && scene->cameras.size() == 3);
    const std::unique_ptr<render::Session> session = start(
        *scene, scene->cameras[0], kDeferredGraph, kNoonSize, {"hdr@lighting", "depth"}, kNoonExposure_ev);
    ASSERT_TRUE(session);
    frame_of(*session).parameters = kSingleReflections;
    double most = 0;
    size_t sunlit = 0;
    for (const scene::Camera& camera : scene->cameras) {
        frame_of(*session).camera = camera;
        const std::vector<glm::vec4> all = frame(*session, scene->lights),
                                     sun = frame(*session, {scene->lights[0]});
        ASSERT_EQ(all.size(), size_t{kNoonSize.width} * kNoonSize.height);
        const shared::ViewConstants& view = session->parts().frames.view();
        const glm::dmat4 to_world = glm::inverse(glm::dmat4(view.projection) * glm::dmat4(view.view));
        for (size_t i = 0; i < all.size(); ++i) {
            const double sun_lx = sun[i].g * std::exp2(-kNoonExposure_ev) * kPi / kWhite;
            if (depth_[i].r <= 0 || sun_lx < kSunlit_lx) continue;
            const double u = (double(i % kNoonSize.width) + 0.5) / kNoonSize.width,
                         v = (double(i / kNoonSize.width) + 0.5) / kNoonSize.height;
            const glm::dvec4 at = to_world * glm::dvec4(u * 2 - 1, v * 2 - 1, depth_[i].r, 1);
            if (distance_to_lamps(glm::dvec3(at) / at.w, scene->lights) < kBesideLamp_m) continue;
            ++sunlit;
            most = std::max(most, all[i].g / double(sun[i].g) - 1);
        }
    }
    std::printf("lamps add at most %.2f %% to the light of %zu sunlit pixels\n", 100 * most, sunlit);
    EXPECT_GT(sunlit, 10000u);
    EXPECT_LT(most, 0.02);
    EXPECT_GT(most, 0.001) << "the lamps are on";
}

}  // namespace
}  // namespace weft::test
