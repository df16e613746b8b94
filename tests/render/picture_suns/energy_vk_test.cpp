// Tests the illuminance of pictures with suns: a matt surface must reflect as much light as the whole picture
// sends to it, although Weft divides the picture into lights and a rest. Pictures without a sun must stay as
// they are.
#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

#include "tests/render/picture_suns/sun_picture.h"
#include "tests/render/sun/box_outline.h"

namespace weft::test {
namespace {

constexpr Extent3D kEnergySize{64, 64, 1};

struct EnergyCase {
    const char* name;
    uint32_t height_px;
    Sky sky;
    std::vector<DrawnSun> suns;
};

DrawnSun drawn_sun(double azimuth_deg, double height_deg, double radius_deg, double lx) {
    DrawnSun sun{towards(azimuth_deg, height_deg), glm::radians(radius_deg), glm::dvec3(1, 0.9, 0.7)};
    sun.radiance *= lx / sun.illuminance_lx().r;
    return sun;
}

glm::dvec3 even_sky(const glm::dvec3& d) {
    return glm::dvec3(2, 3, 5) * (1 + 0.4 * d.y + 0.3 * d.x);
}

// A sky that is brighter near the horizon, over dark ground.
glm::dvec3 hazy_sky(const glm::dvec3& d) {
    return glm::dvec3(2, 3, 4) * (d.y > 0 ? 0.6 + std::exp(-4 * d.y) : 0.3);
}

std::vector<EnergyCase> energy_cases() {
    return {{"SmallAtTheSeam", 256, even_sky, {drawn_sun(180, 35, 0.27, 60)}},
            {"LargeUnderHaze", 128, hazy_sky, {drawn_sun(-100, 25, 6, 80)}},
            {"ThreeAndOneNearThePole",
             256,
             even_sky,
             {drawn_sun(70, 87, 2, 40), drawn_sun(179, 45, 6, 25), drawn_sun(40, 30, 0.27, 20)}}};
}

// A white matt cube. Its edges are the columns of `axes`.
scene::Scene with_white_cube(scene::Scene scene, const glm::dmat3& axes) {
    scene.meshes.push_back(box_mesh(glm::vec3(-1), glm::vec3(1)));
    scene::Material material;
    material.metallic = 0;
    material.specular = 0;
    scene.materials.push_back(material);
    scene.instances.push_back({"cube", 0, 0, glm::mat4(glm::dmat4(axes))});
    return scene;
}

// Returns axes of a cube whose three sides (1, 0, 0), (0, 1, 0) and (0, 0, 1) face a sun at angles of 64, 34
// and 70 degrees.
glm::dmat3 axes_facing(const glm::dvec3& to_sun) {
    const glm::dvec3 own = glm::normalize(glm::dvec3(0.44, 0.83, 0.34));
    const glm::dvec3 axis = glm::cross(own, to_sun);
    return glm::dmat3(glm::rotate(glm::dmat4(1), std::acos(glm::dot(own, to_sun)), glm::normalize(axis)));
}

class PictureEnergy : public PictureSuns, public testing::WithParamInterface<EnergyCase> {};

TEST_P(PictureEnergy, IsThatOfTheWholePicture) {
    const EnergyCase& c = GetParam();
    const SunPicture picture(c.height_px, c.sky, c.suns);
    const glm::dmat3 axes = axes_facing(c.suns[0].to_sun);
    const scene::Scene scene = with_white_cube(surrounded_by(picture), axes);
    EXPECT_EQ(scene.lights.size(), c.suns.size());
    scene::Camera camera;
    const glm::vec3 up(axes * glm::normalize(glm::dvec3(-1, 2, -1)));
    camera.transform = glm::inverse(glm::lookAt(glm::vec3(axes * glm::dvec3(6)), glm::vec3(0), up));
    camera.fov_y_rad = 0.5f;
    const Rendered r = render(scene, camera, kEnergySize, -4, {"hdr"}, kDeferredGraph, kSunParameters);
    ASSERT_EQ(r.images.size(), 1u);
    double worst = 0;
    for (int side = 0; side < 3; ++side) {
        const glm::dvec3 normal = axes[side];
        for (const DrawnSun& sun : c.suns) {  // The horizon cuts no sun.
            ASSERT_GT(std::abs(glm::dot(normal, sun.to_sun)), std::sin(sun.radius_rad)) << side;
        }
        const glm::dvec4 clip = glm::dmat4(r.view.view_projection) * glm::dvec4(normal, 1);
        const glm::dvec2 at = (glm::dvec2(clip) / clip.w * 0.5 + 0.5) * double(kEnergySize.width);
        const size_t pixel = static_cast<size_t>(at.y) * kEnergySize.width + static_cast<size_t>(at.x);
        const glm::dvec3 found = glm::dvec3(r.images.at("hdr")[pixel]) / double(r.pre_exposure);
        const glm::dvec3 wanted = picture.irradiance(normal) / kPi;
        for (int channel = 0; channel < 3; ++channel) {
            const double error = found[channel] / wanted[channel] - 1;
            EXPECT_NEAR(error, 0, 0.005) << "side " << side << ", channel " << channel;
            worst = std::max(worst, std::abs(error));
        }
    }
    std::printf("%s: largest error %.3f %%\n", c.name, worst * 100);
}

INSTANTIATE_TEST_SUITE_P(Pictures, PictureEnergy, testing::ValuesIn(energy_cases()),
                         [](const auto& c) { return std::string(c.param.name); });

bool is_same(const scene::Environment& a, const scene::Environment& b) {
    return a.mips == b.mips && a.scale == b.scale && a.irradiance_over_pi == b.irradiance_over_pi &&
           a.light.mips == b.light.mips && a.light.scale == b.light.scale;
}

// A picture with a bright cloud that is as small as a sun, but not bright enough.
TEST_F(PictureSuns, APictureWithoutASunStaysAsItIs) {
    const glm::dvec3 cloud = towards(40, 50);
    const SunPicture picture(
        64,
        [&](const glm::dvec3& d) { return even_sky(d) * (glm::dot(d, cloud) > std::cos(0.1) ? 15.0 : 1.0); },
        {});
    const scene::Scene scene = with_white_cube(surrounded_by(picture), glm::dmat3(1));
    EXPECT_TRUE(scene.lights.empty());
    EXPECT_TRUE(scene.environment.suns.empty());
    const std::vector<glm::vec3> texels(picture.texels().begin(), picture.texels().end());
    EXPECT_TRUE(
        is_same(scene.environment, scene::build_environment(2 * picture.height(), picture.height(), texels)));
    scene::Camera camera;
    camera.transform = glm::inverse(glm::lookAt(glm::vec3(3, 4, 5), glm::vec3(0), glm::vec3(0, 1, 0)));
    const std::unique_ptr<render::Session> session =
        start(scene, camera, kDeferredGraph, kEnergySize, {"hdr"});
    ASSERT_TRUE(session && draw_frame(*session) && session->finish());
    EXPECT_TRUE(session->parts().scene.lights().empty());
    EXPECT_EQ(session->parts().frames.sun().count, 0u);
    for (const PassDecl& pass : session->plan().graph.passes)
        EXPECT_FALSE(pass.name.starts_with("sunShadows") || pass.name.starts_with("furtherSunShadows"))
            << pass.name;
}

}  // namespace
}  // namespace weft::test
