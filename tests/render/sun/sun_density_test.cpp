// Tests how fine the sun's shadow maps are in the built-in scene "atrium", in texels per pixel. The figures
// are in docs/sun-shadows.md.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/gtc/matrix_transform.hpp>

#include "render/views/sun_cascades.h"
#include "tests/render/shading/ray_scene.h"
#include "weft/scene/builtin_scenes.h"

namespace weft::test {
namespace {

constexpr uint32_t kWidth = 160, kHeight = 90;
// The picture whose pixels are counted.
constexpr double kPictureHeight_px = 720;
constexpr render::SunMaps kDefaultMaps{4, {1024, 1024, 1024, 1024}};

struct Texels {
    double median = 0, least = 0;  // `least`: 5 % of the pixels have fewer texels.
    size_t covered = 0, all = 0;   // Pixels in a map other than the last, and all pixels with a surface.
};

// Returns the index of the first map that contains a point.
uint32_t map_of(const render::SunCascades& sun, const glm::dvec3& point) {
    for (uint32_t i = 0; i + 1 < sun.count; ++i) {
        const double size = kDefaultMaps.size_px[i];
        const glm::dvec2 at =
            glm::dvec2(glm::dmat4(sun.constants.cascades[i].world_to_map) * glm::dvec4(point, 1)) * size;
        if (std::min({at.x, at.y, size - at.x, size - at.y}) >= 6) return i;
    }
    return sun.count - 1;
}

struct SunlitScene {
    scene::Scene scene;
    scene::Camera camera;
    glm::vec3 to_sun{0, 1, 0};
};

// Texels per pixel: the square root of the number of texels of the map on the part of the surface that a
// pixel shows. Surfaces that face away from the sun do not count.
Texels density_of(const SunlitScene& sunlit) {
    const scene::Camera& camera = sunlit.camera;
    const glm::dvec3 to_sun(sunlit.to_sun);
    const render::SurfaceTree surfaces(render::still_surfaces(sunlit.scene, false));
    const render::SunCascades sun = render::sun_cascades(
        camera, 16.0f / 9, {sunlit.to_sun, sunlit.scene.bounds, {&surfaces}, {}}, kDefaultMaps);
    const RayScene rays(sunlit.scene);
    const double tan_y = std::tan(double{camera.fov_y_rad} / 2), tan_x = tan_y * 16 / 9;
    Texels result;
    std::vector<double> counts;
    for (uint32_t i = 0; i < kWidth * kHeight; ++i) {
        const glm::dvec3 way(((i % kWidth + 0.5) / kWidth * 2 - 1) * tan_x,
                             (1 - (i / kWidth + 0.5) / kHeight * 2) * tan_y, -1);
        const glm::dvec3 ray = glm::normalize(glm::dmat3(camera.transform) * way);
        const glm::dvec3 eye(camera.transform[3]);
        const std::optional<RayHit> hit = rays.first(eye, ray, camera.near_m * glm::length(way));
        if (!hit) continue;
        const uint32_t map = map_of(sun, eye + ray * hit->distance_m);
        ++result.all;
        result.covered += map + 1 < sun.count ? 1 : 0;
        if (glm::dot(hit->normal, to_sun) < 1e-3) continue;
        const double pixel = 2 * tan_y / kPictureHeight_px, length = glm::length(way);
        const double seen_m2 = hit->distance_m * hit->distance_m * pixel * pixel / (length * length * length);
        const double lit_m2 =
            seen_m2 * glm::dot(hit->normal, to_sun) / std::max(std::abs(glm::dot(hit->normal, ray)), 1e-3);
        counts.push_back(std::sqrt(lit_m2 / (sun.cascades[map].texel_m.x * sun.cascades[map].texel_m.y)));
    }
    std::ranges::sort(counts);
    result.median = counts[counts.size() / 2];
    result.least = counts[counts.size() / 20];
    std::printf(
        "%s: median %.3f texels per pixel, 5 %% have fewer than %.3f; %.2f %% of the pixels in fitted maps\n",
        camera.name.c_str(), result.median, result.least,
        100.0 * static_cast<double>(result.covered) / static_cast<double>(result.all));
    return result;
}

Texels texels_of_camera(uint32_t camera_index) {
    SunlitScene sunlit{*scene::make_builtin("atrium", {.hour = 15})};
    const auto light =
        std::ranges::find(sunlit.scene.lights, scene::LightType::directional, &scene::Light::type);
    sunlit.to_sun = -glm::normalize(light->direction);
    sunlit.camera = sunlit.scene.cameras.at(camera_index);
    return density_of(sunlit);
}

// A hilly square with sides of `side_m`, and a camera 1.7 m above its middle that looks at the horizon.
SunlitScene terrain(float side_m) {
    constexpr uint32_t kCells = 200;
    SunlitScene sunlit;
    scene::Mesh mesh;
    const auto height_m = [](float x, float z) {
        return 3 * std::sin(x * 0.05f) + 2 * std::sin(z * 0.08f + 1);
    };
    for (uint32_t i = 0; i < (kCells + 1) * (kCells + 1); ++i) {
        const float x = (static_cast<float>(i % (kCells + 1)) / kCells - 0.5f) * side_m;
        const float z = (static_cast<float>(i / (kCells + 1)) / kCells - 0.5f) * side_m;
        mesh.positions.emplace_back(x, height_m(x, z), z);
    }
    mesh.uvs.resize(mesh.positions.size());
    for (uint32_t i = 0; i < kCells * kCells; ++i) {
        const uint32_t first = i / kCells * (kCells + 1) + i % kCells;
        for (const uint32_t corner : {0u, kCells + 1, 1u, 1u, kCells + 1, kCells + 2})
            mesh.indices.push_back(first + corner);
    }
    sunlit.scene.meshes.push_back(std::move(mesh));
    sunlit.scene.materials.emplace_back();
    sunlit.scene.instances.push_back({"terrain", 0, 0, glm::mat4(1)});
    sunlit.scene.bounds = {{-side_m / 2, -5, -side_m / 2}, {side_m / 2, 5, side_m / 2}};
    sunlit.camera.name = "terrain";
    sunlit.camera.transform[3] = glm::vec4(0, height_m(0, 0) + 1.7f, 0, 1);
    sunlit.to_sun = glm::normalize(glm::vec3(0.4f, 0.6f, 0.3f));
    return sunlit;
}

// Maps that cover spheres around parts of the view had a median of 0.427 and a 5th percentile of 0.191 texels
// per pixel.
TEST(SunDensity, OfTheDefaultViewIsThreeTimesThatOfSpheres) {
    const Texels texels = texels_of_camera(0);
    EXPECT_GE(texels.median, 3 * 0.427);
    EXPECT_GE(texels.least, 2.5 * 0.191);
    EXPECT_GE(texels.covered * 100, texels.all * 95);
}

TEST(SunDensity, OfTheOtherViewsIsTwiceThatOfSpheres) {
    const Texels gallery = texels_of_camera(1);
    EXPECT_GE(gallery.median, 2 * 0.527);
    EXPECT_GE(gallery.least, 1.7 * 0.282);
    const Texels pool = texels_of_camera(2);
    EXPECT_GE(pool.median, 2 * 0.346);
    EXPECT_GE(pool.least, 2.5 * 0.131);
}

TEST(SunDensity, OfATerrainOfOneKilometreIsFineNearTheEye) {
    const Texels texels = density_of(terrain(1000));
    EXPECT_GE(texels.median, 0.5);
    EXPECT_GE(texels.covered * 100, texels.all * 80);
}

TEST(SunDensity, IsFineOutsideTheSceneAndAtAWall) {
    SunlitScene sunlit{*scene::make_builtin("atrium", {.hour = 15})};
    sunlit.to_sun = glm::normalize(glm::vec3(-0.2f, 0.65f, 0.74f));
    sunlit.camera = sunlit.scene.cameras.at(0);
    sunlit.camera.name = "outside";
    sunlit.camera.transform =
        glm::inverse(glm::lookAt(glm::vec3(30, 25, 60), glm::vec3(0), glm::vec3(0, 1, 0)));
    const Texels outside = density_of(sunlit);
    EXPECT_GE(outside.covered * 100, outside.all * 95);
    sunlit.camera.name = "at a wall";
    sunlit.camera.transform =
        glm::inverse(glm::lookAt(glm::vec3(2, 1.6f, -8.2f), glm::vec3(2.5f, 1.4f, -12), glm::vec3(0, 1, 0)));
    const Texels wall = density_of(sunlit);
    EXPECT_GE(wall.covered * 100, wall.all * 90);
    EXPECT_GE(wall.median, 1);
}

}  // namespace
}  // namespace weft::test
