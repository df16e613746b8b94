// Tests sun shadows in the built-in scene "atrium" against rays: no light leaks into shadows, and no surface
// shadows itself.
#include <cstdlib>

#include "tests/render/shading/ray_scene.h"
#include "tests/render/shading/reference_light.h"
#include "tests/render/sun/sun_fixture.h"

namespace weft::test {
namespace {

// Result of casting rays around the point in a pixel, over the area of the shadow filter. `all`: all rays
// reach the sun. `none`: all rays are blocked, see sunlight(). `some`: every other result.
enum class Sunlight : uint8_t { all, none, some };

struct Pixel {
    glm::dvec3 at{0}, normal{0};
};

// Casts up to `steps` × `steps` rays towards the sun. They start on the plane of the surface. Seen from the
// sun, the starting points form a square, which extends `reach_m` from the pixel's point to each side. A
// shadow map may miss casters that rise less than `lift_m` above the surface, so such casters do not make a
// point dark. A ray that meets only masked surfaces (leaves) counts as neither lit nor dark, because the
// holes of leaves are smaller than the texels of shadow maps.
Sunlight sunlight(const RayScene& rays, const Pixel& pixel, const glm::dvec3& to_sun, double reach_m,
                  double lift_m, int steps) {
    const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), to_sun)),
                     up = glm::cross(to_sun, right);
    const double cos_light = glm::dot(pixel.normal, to_sun), step_m = 2 * reach_m / (steps - 1);
    int lit = 0, dark = 0, cast = 0;
    for (; cast < steps * steps && (lit == cast || dark == cast); ++cast) {
        const glm::dvec3 across =
            right * (cast % steps * step_m - reach_m) + up * (cast / steps * step_m - reach_m);
        const glm::dvec3 from = pixel.at + across - to_sun * (glm::dot(across, pixel.normal) / cos_light);
        const bool is_free = !rays.is_blocked(from, to_sun, 1e-3, Masks::solid);
        lit += is_free ? 1 : 0;
        dark += !is_free && rays.is_blocked(from, to_sun, 1e-3, Masks::absent) &&
                        rays.is_blocked(from + pixel.normal * lift_m, to_sun, 0, Masks::absent)
                    ? 1
                    : 0;
    }
    return lit == cast ? Sunlight::all : (dark == cast ? Sunlight::none : Sunlight::some);
}

struct Count {
    size_t lit = 0, dark = 0, leaks = 0, acne = 0;
};

class SunInTheAtrium : public SunShadows {
 protected:
    // Tests every `step`th pixel in both directions. If all rays of a pixel reach the sun, or none does, the
    // shadow map must agree.
    void expect_sound(uint32_t camera_index, float hour, Extent3D size, uint32_t step) {
        const scene::Scene scene = atrium(hour);
        const RayScene rays(scene);
        const scene::Camera& camera = scene.cameras.at(camera_index);
        const Seen seen =
            run(start(scene, camera, kSunGraphs + "surfaces.json", size, {"seen", "normal", "depth"}));
        ASSERT_EQ(seen.share.size(), size_t{size.width} * size.height);
        Count count;
        for (uint32_t y = 1; y < size.height; y += step)
            for (uint32_t x = 1; x < size.width; x += step)
                if (const std::optional<Pixel> pixel = judged(scene, rays, camera, seen, size, x, y))
                    judge(rays, seen, *pixel, seen.share[size_t{y} * size.width + x], count);
        std::printf("camera %s, %g h: of %zu points in shadow %zu leak, of %zu in the sun %zu are darkened\n",
                    camera.name.c_str(), double{hour}, count.dark, count.leaks, count.lit, count.acne);
        EXPECT_GT(count.dark, 300u);
        EXPECT_EQ(count.leaks, 0u);
        EXPECT_LE(count.acne, count.lit / 500);
    }

 private:
    // Returns the surface point in a pixel, or nullopt if this test cannot judge the surface.
    static std::optional<Pixel> judged(const scene::Scene& scene, const RayScene& rays,
                                       const scene::Camera& camera, const Seen& seen, Extent3D size,
                                       uint32_t x, uint32_t y) {
        const double tan_y = std::tan(double{camera.fov_y_rad} / 2), tan_x = tan_y * size.width / size.height;
        const glm::dvec3 eye(camera.transform[3]), to_sun(seen.sun.constants.to_sun);
        const glm::dvec3 ray = glm::normalize(glm::dmat3(camera.transform) *
                                              glm::dvec3(((x + 0.5) / size.width * 2 - 1) * tan_x,
                                                         (1 - (y + 0.5) / size.height * 2) * tan_y, -1));
        const std::optional<RayHit> hit = rays.first(eye, ray, camera.near_m);
        if (!hit || glm::dot(hit->normal, to_sun) < 0.05) return std::nullopt;
        // Masked surfaces are leaves. They are smaller than texels of the shadow map and overlap, so they
        // cannot be judged.
        if (scene.materials[hit->material].alpha_mode == scene::AlphaMode::mask) return std::nullopt;
        // Through the holes of leaves, a ray and a pixel may see different surfaces. Such pixels are skipped;
        // they are recognised because the distances differ.
        const size_t i = size_t{y} * size.width + x;
        const double before_eye_m = hit->distance_m * glm::dot(ray, -glm::dvec3(camera.transform[2]));
        if (std::abs(seen.depths[i].r * before_eye_m / camera.near_m - 1) > 1e-3) return std::nullopt;
        // A shading normal that faces away from the sun makes the surface dark, whatever the shadow map says.
        if (glm::dot(octahedral_normal(seen.normals[i]), to_sun) < 0.05) return std::nullopt;
        return Pixel{eye + ray * hit->distance_m, hit->normal};
    }

    static void judge(const RayScene& rays, const Seen& seen, const Pixel& pixel, float share, Count& count) {
        // Largest difference from fully dark or fully lit that counts as correct, as a share of the sun's
        // light.
        constexpr float kTolerated = 0.1f;
        // Rays along each side of the square of rays. The cords of lamps are half a texel wide, so kFew rays
        // may miss a cord that the map contains. So if the map darkens a pixel where all these rays reach the
        // sun, the pixel counts as wrong only if kMany rays give the same result.
        constexpr int kFew = 5, kMany = 49;
        const glm::dvec3 to_sun(seen.sun.constants.to_sun);
        const double texel_m = texel_at(seen, glm::vec3(pixel.at));
        const auto truth = [&](int steps) {
            return sunlight(rays, pixel, to_sun, 3 * texel_m, 4 * texel_m, steps);
        };
        const Sunlight sun = truth(kFew);
        count.lit += sun == Sunlight::all ? 1 : 0;
        count.dark += sun == Sunlight::none ? 1 : 0;
        count.leaks += sun == Sunlight::none && share > kTolerated ? 1 : 0;
        const bool is_darkened = sun == Sunlight::all && share < 1 - kTolerated;
        count.acne += is_darkened && truth(kMany) == Sunlight::all ? 1 : 0;
    }
};

TEST_F(SunInTheAtrium, IsSoundInASmallPicture) {
    expect_sound(0, 10, {192, 108, 1}, 2);
}

class Views : public SunInTheAtrium, public ::testing::WithParamInterface<std::tuple<uint32_t, float>> {};

TEST_P(Views, LeakNoLightAndShadowNothingThatIsLit) {
    if (std::getenv("WEFT_EXTENDED") == nullptr) GTEST_SKIP() << "only with WEFT_EXTENDED";
    expect_sound(std::get<0>(GetParam()), std::get<1>(GetParam()), {480, 270, 1}, 4);
}

INSTANTIATE_TEST_SUITE_P(Atrium, Views,
                         ::testing::Combine(::testing::Values(0u, 1u, 2u), ::testing::Values(10.0f, 17.0f)),
                         [](const auto& c) {
                             return "Camera" + std::to_string(std::get<0>(c.param)) + "At" +
                                    std::to_string(static_cast<int>(std::get<1>(c.param)));
                         });

}  // namespace
}  // namespace weft::test
