// Tests the highlights of suns in pictures: what metal planes reflect is compared with the integral over the
// disc that was drawn in the picture.
#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

#include "tests/render/picture_suns/sun_picture.h"
#include "tests/render/shading/quad_scene.h"
#include "tests/render/shading/reference_disc.h"

namespace weft::test {
namespace {

constexpr Extent3D kHighlightSize{5, 5, 1};
// Roughnesses that the G-buffer stores exactly: 0.051, 0.1, 0.2, 0.4 and 0.6.
constexpr std::array kStoredRoughness{13, 26, 51, 102, 153};
// √ of the base colour, in steps that the G-buffer stores exactly.
const glm::dvec3 kRootColor = glm::dvec3(255, 204, 102) / 255.0;
// Distance between the middles of the planes, and from the eye to the middle of a plane.
constexpr float kNextPlane_m = 20, kEyeDistance_m = 2;

struct HighlightCase {
    const char* name;
    const char* graph;
    uint32_t height_px;
    double radius_deg, azimuth_deg, height_deg;
};

// A plane for each roughness, side by side.
scene::Scene with_metal_planes(scene::Scene scene) {
    scene.meshes.push_back(ground_mesh());
    for (size_t i = 0; i < kStoredRoughness.size(); ++i) {
        scene::Material metal;
        metal.base_color = glm::vec4(kRootColor * kRootColor, 1);
        metal.metallic = 1;
        metal.roughness = float(kStoredRoughness[i]) / 255;
        scene.materials.push_back(metal);
        const glm::vec3 at(kNextPlane_m * float(i), 0, 0);
        scene.instances.push_back({"plane", 0, uint32_t(i), glm::translate(glm::mat4(1), at)});
    }
    return scene;
}

class PictureHighlight : public PictureSuns, public testing::WithParamInterface<HighlightCase> {
 protected:
    // Draws the picture in which the middle pixel mirrors the sun, and the others what is up to `reach_rad`
    // beside it.
    std::vector<glm::vec4> draw_plane(render::Session& session, size_t plane, const glm::dvec3& to_sun,
                                      double reach_rad) {
        const glm::vec3 middle(kNextPlane_m * float(plane), 0, 0);
        const glm::vec3 eye = middle + kEyeDistance_m * glm::vec3(-to_sun.x, to_sun.y, -to_sun.z);
        scene::Camera& camera = frame_of(session).camera;
        camera.transform = glm::inverse(glm::lookAt(eye, middle, glm::vec3(0, 1, 0)));
        camera.fov_y_rad = float(2 * reach_rad);
        frame_of(session).parameters = kSunParameters;
        if (!draw_frame(session) || !session.finish()) return {};
        const std::vector<vk::ReadbackData> read = session.take_readbacks();
        return read.size() == 1 ? render::decode_texels(read[0].format, read[0].bytes)
                                : std::vector<glm::vec4>{};
    }
};

// Returns the point of the plane y = 0 that a pixel shows.
glm::dvec3 point_in_pixel(const shared::ViewConstants& view, size_t pixel) {
    const glm::dvec2 at(double(pixel % kHighlightSize.width) + 0.5,
                        double(pixel / kHighlightSize.width) + 0.5);
    const glm::dvec4 far = glm::inverse(glm::dmat4(view.view_projection)) *
                           glm::dvec4(at * 2.0 / double(kHighlightSize.width) - 1.0, 0.5, 1);
    const glm::dvec3 eye(view.eye), ray = glm::dvec3(far) / far.w - eye;
    return eye - ray * (eye.y / ray.y);
}

TEST_P(PictureHighlight, IsTheIntegralOverTheDisc) {
    const HighlightCase& c = GetParam();
    DrawnSun sun{towards(c.azimuth_deg, c.height_deg), glm::radians(c.radius_deg), glm::dvec3(1)};
    sun.radiance = glm::dvec3(1000);
    const SunPicture picture(
        c.height_px, [](const glm::dvec3&) { return glm::dvec3(0); }, std::array{sun});
    const scene::Scene scene = with_metal_planes(surrounded_by(picture));
    ASSERT_EQ(scene.lights.size(), 1u);
    const std::unique_ptr<render::Session> session =
        start(scene, {}, graph_path(c.graph), kHighlightSize, {"hdr"});
    ASSERT_TRUE(session);
    double worst = 0;
    for (size_t plane = 0; plane < kStoredRoughness.size(); ++plane) {
        const double roughness = kStoredRoughness[plane] / 255.0;
        // All pixels must show the plane.
        const double reach_rad =
            std::min(glm::radians(c.height_deg) / 2, std::hypot(sun.radius_rad, 2 * roughness * roughness));
        const std::vector<glm::vec4> found = draw_plane(*session, plane, sun.to_sun, reach_rad);
        ASSERT_EQ(found.size(), size_t{kHighlightSize.width} * kHighlightSize.height);
        const ReferenceSurface metal{
            .base_color = kRootColor * kRootColor, .metallic = 1, .roughness = roughness};
        const shared::ViewConstants& view = session->parts().frames.view();
        std::vector<glm::dvec3> wanted;
        for (size_t i = 0; i < found.size(); ++i) {
            const glm::dvec3 to_eye = glm::normalize(glm::dvec3(view.eye) - point_in_pixel(view, i));
            wanted.push_back(reference_disc(metal, to_eye, sun.to_sun, sun.radius_rad) *
                             sun.illuminance_lx());
        }
        // Relative where the highlight is bright; elsewhere an error of 5 % of the tenth of its middle is
        // allowed.
        const glm::dvec3 peak = wanted[wanted.size() / 2];
        double worst_here = 0;
        for (size_t i = 0; i < found.size(); ++i)
            for (int channel = 0; channel < 3; ++channel) {
                const double error =
                    (double(found[i][channel]) / double(session->pre_exposure()) - wanted[i][channel]) /
                    std::max(wanted[i][channel], peak[channel] * 0.1);
                EXPECT_NEAR(error, 0, 0.05) << "roughness " << roughness << ", pixel " << i << ", channel "
                                            << channel << ": " << wanted[i][channel];
                worst_here = std::max(worst_here, std::abs(error));
            }
        std::printf("%s, roughness %.2f: largest error %.2f %%\n", c.name, roughness, worst_here * 100);
        worst = std::max(worst, worst_here);
    }
    EXPECT_GT(worst, 0) << "nothing was compared";
}

INSTANTIATE_TEST_SUITE_P(Pictures, PictureHighlight,
                         testing::Values(HighlightCase{"SmallAtTheSeam", "deferred", 1024, 0.27, 180, 40},
                                         HighlightCase{"TwoDegreesLow", "forward", 512, 2, -70, 25},
                                         HighlightCase{"SixDegrees", "deferred", 256, 6, 20, 50}),
                         [](const auto& c) { return std::string(c.param.name); });

}  // namespace
}  // namespace weft::test
