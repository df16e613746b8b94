// Tests the shadows of lamps in the built-in scene "atrium" at night against rays from the lamps.
#include <cstdlib>

#include "shared/lamp_shadow.glsl"
#include "tests/render/session_fixture.h"
#include "tests/render/shading/ray_scene.h"
#include "tests/render/shading/reference_light.h"

namespace weft::test {
namespace {

constexpr Extent3D kPixels{100, 100, 1};
constexpr double kRayMapSize = 256;  // As in lamps.json.

// The atrium at night with only the spots, `lanterns` lanterns and `bulbs` bulbs, evenly chosen.
scene::Scene atrium_with(size_t lanterns, size_t bulbs) {
    Result<scene::Scene> scene = scene::make_builtin("atrium", {.hour = 22});
    EXPECT_TRUE(scene);
    std::vector<scene::Light> spots, all_lanterns, all_bulbs;
    for (const scene::Light& light : scene->lights) {
        if (light.type == scene::LightType::spot) spots.push_back(light);
        if (light.name.starts_with("lantern")) all_lanterns.push_back(light);
        if (light.name.starts_with("bulb")) all_bulbs.push_back(light);
    }
    scene->lights = spots;
    for (size_t i = 0; i < lanterns; ++i)
        scene->lights.push_back(all_lanterns[i * all_lanterns.size() / lanterns]);
    for (size_t i = 0; i < bulbs; ++i) scene->lights.push_back(all_bulbs[i * all_bulbs.size() / bulbs]);
    return std::move(*scene);
}

// Returns the scene without the surfaces that emit light, because these cast no shadows of lamps.
scene::Scene casters_of(scene::Scene scene) {
    std::erase_if(scene.instances, [&](const scene::Instance& instance) {
        return scene.materials[instance.material].emissive != glm::vec3(0);
    });
    return scene;
}

// The surface point in a pixel.
struct Point {
    glm::dvec3 at{0}, normal{0};
    double texel_m = 0;  // Width at the point of a texel of the map of the lamp.
    double from_m = 0;   // The distance from the lamp to the near plane of its view.
};

enum class Lit : uint8_t { all, none, some };

// Casts rays from the lamp to points around the surface point, up to a distance of two texels, the
// radius of the filter. A map may miss
// casters that rise less than two texels above the surface.
Lit truth(const RayScene& rays, const shared::Light& lamp, const Point& point) {
    constexpr int kSteps = 5;
    const glm::dvec3 from(lamp.position), to_lamp = glm::normalize(from - point.at);
    const glm::dvec3 right = glm::normalize(
        glm::cross(std::abs(to_lamp.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0), to_lamp));
    const glm::dvec3 up = glm::cross(to_lamp, right);
    const auto is_blocked = [&](const glm::dvec3& at, Masks masks) {
        const double distance_m = glm::distance(from, at);
        const std::optional<double> hit =
            rays.first_distance(from, (at - from) / distance_m, point.from_m, masks);
        return hit && *hit < distance_m - 1e-3;
    };
    int lit = 0, dark = 0, cast = 0;
    for (; cast < kSteps * kSteps && (lit == cast || dark == cast); ++cast) {
        const glm::dvec3 across =
            (right * double(cast % kSteps - 2) + up * double(cast / kSteps - 2)) * point.texel_m;
        const glm::dvec3 at =
            point.at + across - to_lamp * (glm::dot(across, point.normal) / glm::dot(to_lamp, point.normal));
        lit += is_blocked(at, Masks::solid) ? 0 : 1;
        dark += is_blocked(at + (point.normal + to_lamp) * (2 * point.texel_m), Masks::absent) ? 1 : 0;
    }
    return lit == cast ? Lit::all : (dark == cast ? Lit::none : Lit::some);
}

struct Count {
    size_t lit = 0, dark = 0, leaks = 0, darkened = 0;
};

class LampRays : public SessionTest {
 protected:
    void expect_sound(const scene::Scene& scene, uint32_t camera_index, uint32_t step) {
        const scene::Camera& camera = scene.cameras.at(camera_index);
        const Rendered drawn = render(scene, camera, kPixels, 0, {"seen", "depth", "normal"},
                                      WEFT_SOURCE_DIR "/tests/render/lamp_shadows/lamps.json");
        ASSERT_EQ(drawn.images.size(), 3u);
        const scene::Scene casters = casters_of(scene);
        const RayScene surfaces(scene), rays(casters);
        Count count;
        for (uint32_t i = 0; i < kPixels.width * kPixels.height; i += step)
            if (const std::optional<Point> point = surface_point(scene, surfaces, camera, drawn, i))
                for (size_t lamp = 0; lamp < scene.lights.size(); ++lamp)
                    judge(rays, drawn, lamp, *point, i, count);
        const size_t wrong = count.leaks + count.darkened, judged = count.lit + count.dark;
        std::printf("camera %s, %zu lamps: of %zu dark lookups %zu leak, of %zu lit ones %zu are darkened\n",
                    camera.name.c_str(), scene.lights.size(), count.dark, count.leaks, count.lit,
                    count.darkened);
        EXPECT_GT(count.dark, 200u);
        EXPECT_GT(count.lit, 200u);
        EXPECT_LE(wrong, judged / 200) << "0.5 % of " << judged;
    }

 private:
    // Returns the point in a pixel, or nullopt if the surface has holes or a ray finds another one.
    static std::optional<Point> surface_point(const scene::Scene& scene, const RayScene& rays,
                                              const scene::Camera& camera, const Rendered& drawn,
                                              uint32_t i) {
        const double tan = std::tan(double{camera.fov_y_rad} / 2);
        const double x = (i % kPixels.width + 0.5) / kPixels.width * 2 - 1,
                     y = 1 - (i / kPixels.width + 0.5) / kPixels.height * 2;
        const glm::dvec3 eye(camera.transform[3]);
        const glm::dvec3 ray =
            glm::normalize(glm::dmat3(camera.transform) * glm::dvec3(x * tan, y * tan, -1));
        const std::optional<RayHit> hit = rays.first(eye, ray, camera.near_m);
        if (!hit || scene.materials[hit->material].alpha_mode == scene::AlphaMode::mask) return std::nullopt;
        const double before_eye_m = hit->distance_m * glm::dot(ray, -glm::dvec3(camera.transform[2]));
        if (std::abs(drawn.images.at("depth")[i].r * before_eye_m / camera.near_m - 1) > 1e-3)
            return std::nullopt;
        return Point{eye + ray * hit->distance_m, hit->normal};
    }

    // Judges one lamp at a point, if the light of the lamp reaches the front of the surface.
    static void judge(const RayScene& rays, const Rendered& drawn, size_t lamp, Point point, uint32_t pixel,
                      Count& count) {
        constexpr float kTolerated = 0.1f;
        const size_t directional = drawn.lights.size() - lamps_of(drawn);
        const shared::Light& light = drawn.lights[directional + lamp];
        glm::dvec3 to_lamp;
        if (incident(light, point.at, to_lamp).r <= 0 || glm::dot(point.normal, to_lamp) < 0.1 ||
            glm::dot(octahedral_normal(drawn.images.at("normal")[pixel]), to_lamp) < 0.1)
            return;
        const bool is_spot = light.type == shared::kLightSpot;
        const glm::dvec3 sides = glm::abs(to_lamp);
        const double along =
            is_spot ? -glm::dot(to_lamp, glm::dvec3(light.direction)) : std::max({sides.x, sides.y, sides.z});
        const double cosine = is_spot ? double{-light.cone_offset / light.cone_scale} : std::sqrt(0.5);
        const double distance_m = glm::distance(point.at, glm::dvec3(light.position));
        point.texel_m = 2 * double{shared::kLampMapMargin} * std::sqrt(1 - cosine * cosine) / cosine *
                        distance_m * along / kRayMapSize;
        point.from_m = double{shared::kLampMapNear_m} / along;
        const float share = drawn.images.at("seen")[lamp * kPixels.width * kPixels.height + pixel].r;
        ASSERT_GE(share, 0) << "lamp " << lamp << " has no map";
        const Lit lit = truth(rays, light, point);
        count.lit += lit == Lit::all ? 1 : 0;
        count.dark += lit == Lit::none ? 1 : 0;
        count.leaks += lit == Lit::none && share > kTolerated ? 1 : 0;
        count.darkened += lit == Lit::all && share < 1 - kTolerated ? 1 : 0;
    }

    static size_t lamps_of(const Rendered& drawn) {
        return static_cast<size_t>(std::ranges::count_if(drawn.lights, [](const shared::Light& light) {
            return light.type != shared::kLightDirectional;
        }));
    }
};

TEST_F(LampRays, AgreeWithEightLamps) {
    expect_sound(atrium_with(4, 0), 1, 3);
}

TEST_F(LampRays, AgreeWith64Lamps) {
    if (std::getenv("WEFT_EXTENDED") == nullptr) GTEST_SKIP() << "only with WEFT_EXTENDED";
    for (const uint32_t camera : {0u, 1u, 2u}) expect_sound(atrium_with(24, 36), camera, 1);
}

}  // namespace
}  // namespace weft::test
