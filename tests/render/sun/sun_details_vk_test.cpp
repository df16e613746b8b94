// Tests that thin objects of the built-in scene "atrium" cast shadows: the wires of the garlands and the
// rings of the armillary sphere, with maps of the default size.
#include "tests/render/shading/ray_scene.h"
#include "tests/render/sun/sun_fixture.h"

namespace weft::test {
namespace {

constexpr Extent3D kPicture{480, 270, 1};

// Returns the scene with the instances of this name, or with all others.
scene::Scene part_of(const scene::Scene& scene, const std::string& name, bool with) {
    scene::Scene part = scene;
    std::erase_if(part.instances,
                  [&](const scene::Instance& instance) { return (instance.name == name) != with; });
    return part;
}

class SunDetails : public SunShadows, public ::testing::WithParamInterface<const char*> {};

// Counts the pixels that only this object keeps from the sun, with the middle of the pixel at least a quarter
// of its width inside the shadow. The map must darken them.
TEST_P(SunDetails, CastShadows) {
    const scene::Scene scene = atrium(15);
    const scene::Camera& camera = scene.cameras.at(0);
    const scene::Scene object = part_of(scene, GetParam(), true), others = part_of(scene, GetParam(), false);
    ASSERT_FALSE(object.instances.empty());
    const RayScene rays(scene), of_object(object), of_others(others);
    const Seen seen = run(start(scene, camera, kSunGraphs + "surfaces.json", kPicture, {"seen"}));
    ASSERT_EQ(seen.share.size(), size_t{kPicture.width} * kPicture.height);
    const glm::dvec3 to_sun(seen.sun.constants.to_sun), eye(camera.transform[3]);
    const double tan_y = std::tan(double{camera.fov_y_rad} / 2),
                 tan_x = tan_y * kPicture.width / kPicture.height;
    double shares = 0;
    size_t shaded = 0, darkened = 0;
    for (uint32_t i = 0; i < seen.share.size(); ++i) {
        const glm::dvec3 ray =
            glm::normalize(glm::dmat3(camera.transform) *
                           glm::dvec3(((i % kPicture.width + 0.5) / kPicture.width * 2 - 1) * tan_x,
                                      (1 - (i / kPicture.width + 0.5) / kPicture.height * 2) * tan_y, -1));
        const std::optional<RayHit> hit = rays.first(eye, ray, double{camera.near_m});
        if (!hit || glm::dot(hit->normal, to_sun) < 0.1) continue;
        const glm::dvec3 at = eye + ray * hit->distance_m;
        if (!of_object.is_blocked(at, to_sun, 1e-3, Masks::solid)) continue;
        if (of_others.is_blocked(at, to_sun, 1e-3, Masks::solid)) continue;
        ++shaded;
        shares += double{seen.share[i]};
        darkened += seen.share[i] < 0.75f ? 1 : 0;
    }
    std::printf("%s: %zu pixels in its shadow, of these %zu darkened; the sun's mean share is %.3f\n",
                GetParam(), shaded, darkened, shares / static_cast<double>(shaded));
    EXPECT_GT(shaded, 40u);
    EXPECT_GE(darkened * 10, shaded * 9);
}

INSTANTIATE_TEST_SUITE_P(Atrium, SunDetails, ::testing::Values("garland_wire", "armillary_rings"),
                         [](const auto& c) { return std::string(c.param); });

}  // namespace
}  // namespace weft::test
