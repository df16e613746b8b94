#include "render/views/further_suns.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace weft::render {
namespace {

static_assert(sizeof(shared::FurtherSuns) == 672);

// Width in texels of the border between the bounding sphere of the objects and the edge of a shadow map. The
// border has room for the filter and for the offset along the normal.
constexpr double kFurtherBorderTexels = 6;

// The matrix from world space to a space in which x and y are in the plane of the map and z points to the
// light.
glm::dmat4 light_space(const glm::dvec3& to_sun) {
    const glm::dvec3 up = std::abs(to_sun.y) < 0.99 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, -1);
    return glm::lookAt(glm::dvec3(0), -to_sun, up);
}

// The bounding sphere of a box.
struct Sphere {
    glm::dvec3 center{0};
    double radius_m = 0;
};

Sphere sphere_around(const scene::Bounds& bounds) {
    const glm::dvec3 center = (glm::dvec3(bounds.min) + glm::dvec3(bounds.max)) * 0.5;
    return {center, std::max(glm::length(glm::dvec3(bounds.max) - center), 1e-3)};
}

// Writes the constants and the view of the map of a light. A map without texels, and the map of a light that
// is not directional, stay 0.
void make_map(const shared::Light& light, const Sphere& sphere, uint32_t side_px, shared::FurtherSun& map,
              shared::ViewConstants& constants) {
    if (side_px == 0 || light.type != shared::kLightDirectional) return;
    const glm::dvec3 to_sun = -glm::normalize(glm::dvec3(light.direction));
    const double size_px = side_px;
    const double texel_m = 2 * sphere.radius_m / std::max(size_px - 2 * kFurtherBorderTexels, 1.0);
    const glm::dmat4 view = light_space(to_sun);
    const glm::dvec3 middle(view * glm::dvec4(sphere.center, 1));
    const double side_m = texel_m * size_px, depth_m = 2.02 * sphere.radius_m;
    // The matrix from light space to clip space: x and y from -1 to 1, y downwards, and depth 1 nearest to
    // the light.
    glm::dmat4 projection(1);
    projection[0][0] = 2 / side_m;
    projection[1][1] = -2 / side_m;
    projection[2][2] = 1 / depth_m;
    projection[3] = glm::dvec4(-2 * middle.x / side_m, 2 * middle.y / side_m, 0.5 - middle.z / depth_m, 1);
    const glm::dmat4 to_clip = projection * view;
    const glm::dmat4 to_map = glm::translate(glm::dmat4(1), glm::dvec3(0.5, 0.5, 0)) *
                              glm::scale(glm::dmat4(1), glm::dvec3(0.5, 0.5, 1)) * to_clip;
    map = {glm::mat4(to_map), glm::vec3(to_sun), static_cast<float>(texel_m), glm::vec3(0),
           static_cast<float>(depth_m)};
    constants.view = glm::mat4(view);
    constants.projection = glm::mat4(projection);
    constants.view_projection = constants.steady_view_projection = constants.prev_view_projection =
        glm::mat4(to_clip);
    constants.inverse_view_projection = glm::mat4(glm::inverse(to_clip));
    constants.eye = glm::vec3(sphere.center + to_sun * (depth_m / 2));
    constants.viewport_px = glm::vec2(static_cast<float>(size_px));
    constants.inverse_viewport = 1.0f / constants.viewport_px;
}

// If `view`, which the pass draws, is a view of the list `list`, sets the size of its shadow map.
void note_sizes(const PassDecl& pass, const std::string& view, const char* list,
                std::span<uint32_t> sizes_px) {
    for (uint32_t i = 0; i < sizes_px.size(); ++i)
        if (view == std::string(list) + "(" + std::to_string(i) + ")")
            sizes_px[i] = std::max(
                sizes_px[i], pass.state.viewport ? pass.state.viewport->width : pass.render_extent.width);
}

}  // namespace

FurtherSunSizes further_sun_sizes(const FramePlan& plan) {
    FurtherSunSizes sizes;
    for (const PassDecl& pass : plan.graph.passes)
        for (const std::string& view : pass.drawn_views()) {
            note_sizes(pass, view, kFurtherSunViews, sizes.further);
            note_sizes(pass, view, kSceneSunViews, sizes.scene);
        }
    return sizes;
}

FurtherSunMaps further_sun_maps(std::span<const shared::Light> lights, const scene::Bounds& bounds,
                                const scene::Bounds& still_bounds, const FurtherSunSizes& sizes_px) {
    FurtherSunMaps maps;
    const Sphere all = sphere_around(bounds), still = sphere_around(still_bounds);
    for (uint32_t i = 0; i < sizes_px.further.size() && i + 1 < lights.size(); ++i)
        make_map(lights[i + 1], all, sizes_px.further[i], maps.constants.items[i], maps.views[i]);
    for (uint32_t i = 0; i < sizes_px.scene.size() && i < lights.size(); ++i)
        make_map(lights[i], still, sizes_px.scene[i], maps.constants.scene[i], maps.scene_views[i]);
    return maps;
}

}  // namespace weft::render
