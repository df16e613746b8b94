#include "render/views/sun_cascades.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "graph/parse/debug_view.h"

namespace weft::render {
namespace {

static_assert(sizeof(shared::SunCascade) == 80 && sizeof(shared::SunConstants) == 336);

// Weight of the split into equal ratios in split_distances(); the split into equal steps has the weight
// 1 - kRatioShare. Zhang et al. use 0.5. A larger weight gives finer shadows near the eye. It is used here,
// because rooms and courtyards are seen from close by.
constexpr double kRatioShare = 0.6;
// Maximum distance from the eye at which shadows are drawn, in metres. It applies only if the diameter of the
// scene is larger than this value.
constexpr double kMostReach_m = 250;
// Width in texels of the border between a cascade's sphere and the edge of its map. The border has room for
// the radius of the filter, the offset along the normal, and half a texel for snapping to whole texels.
constexpr double kBorderTexels = 6;
// Margin beyond the scene's bounds, relative to their depth, so that rounding does not cut off objects on the
// bounds.
constexpr double kDepthMargin = 0.01;

struct Axes {
    glm::dvec3 right, down, to_sun;
};

Axes axes_of(const glm::vec3& to_sun) {
    const glm::dvec3 back = glm::normalize(glm::dvec3(to_sun));
    const glm::dvec3 up = std::abs(back.y) < 0.99 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, -1);
    const glm::dvec3 right = glm::normalize(glm::cross(up, back));
    return {right, -glm::cross(back, right), back};
}

struct Sphere {
    glm::dvec3 center{0};
    double radius_m = 0;
};

Sphere sphere_of(const scene::Bounds& bounds) {
    const glm::dvec3 least(bounds.min), most(bounds.max);
    return {(least + most) * 0.5, glm::length(most - least) * 0.5};
}

// Returns the smallest sphere around the part of the camera's frustum between two distances from the eye. By
// symmetry the centre is on the view axis. The sphere touches the corners of both ends, or only the corners
// of the far end.
Sphere sphere_of_part(const scene::Camera& camera, double aspect, double from_m, double to_m) {
    const double tan_y = std::tan(double{camera.fov_y_rad} * 0.5);
    const double cos_corner = 1 / std::sqrt(1 + tan_y * tan_y * (1 + aspect * aspect));
    const double along = std::min((from_m + to_m) * 0.5 / cos_corner, to_m * cos_corner);
    const glm::dmat4 world(camera.transform);
    const double radius2 = to_m * to_m - 2 * to_m * along * cos_corner + along * along;
    return {glm::dvec3(world[3]) - glm::dvec3(world[2]) * along, std::sqrt(radius2)};
}

// The range of depths that contains the whole scene. Depth is dot(position, to_sun): larger is nearer to the
// sun.
struct DepthRange {
    double farthest = 0, nearest = 0;
};

DepthRange depth_range(const scene::Bounds& bounds, const glm::dvec3& to_sun) {
    DepthRange range{std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest()};
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 at((corner & 1) != 0 ? bounds.max.x : bounds.min.x,
                            (corner & 2) != 0 ? bounds.max.y : bounds.min.y,
                            (corner & 4) != 0 ? bounds.max.z : bounds.min.z);
        range.farthest = std::min(range.farthest, glm::dot(at, to_sun));
        range.nearest = std::max(range.nearest, glm::dot(at, to_sun));
    }
    const double margin = std::max((range.nearest - range.farthest) * kDepthMargin, 0.01);
    return {range.farthest - margin, range.nearest + margin};
}

// Sets one row of a matrix, so that the row computes dot(factors, position) + offset.
void set_row(glm::mat4& matrix, int row, const glm::vec3& factors, double offset) {
    for (int column = 0; column < 3; ++column) matrix[column][row] = factors[column];
    matrix[3][row] = static_cast<float>(offset);
}

// The matrices of one cascade. The axes are rounded to float first, and do not depend on the position and
// direction of the camera. The origin is a whole number of texels, which a float represents exactly. So if
// the camera moves, the map moves by exactly whole texels, and static shadows do not flicker.
struct MapMatrices {
    glm::mat4 to_map{0}, to_clip{0};
    glm::dvec2 origin_texels{0};
};

MapMatrices matrices_of(const Sphere& sphere, double texel_m, uint32_t size_px, const Axes& axes,
                        const DepthRange& depth) {
    const double side_m = texel_m * size_px;
    const std::array<glm::vec3, 2> across{glm::vec3(axes.right / side_m), glm::vec3(axes.down / side_m)};
    MapMatrices matrices;
    for (int row = 0; row < 2; ++row) {
        const glm::vec3& axis = across[static_cast<size_t>(row)];
        const double center_texels = glm::dot(glm::dvec3(axis), sphere.center) * size_px;
        const double origin = std::round(center_texels - 0.5 * size_px);
        matrices.origin_texels[row] = origin;
        set_row(matrices.to_map, row, axis, -origin / size_px);
        set_row(matrices.to_clip, row, axis * 2.0f, -2 * origin / size_px - 1);
    }
    const double depth_m = depth.nearest - depth.farthest;
    set_row(matrices.to_map, 2, glm::vec3(axes.to_sun / depth_m), -depth.farthest / depth_m);
    set_row(matrices.to_clip, 2, glm::vec3(axes.to_sun / depth_m), -depth.farthest / depth_m);
    matrices.to_map[3][3] = matrices.to_clip[3][3] = 1;
    return matrices;
}

// Returns the view constants of a shadow map. The projection is parallel, so depth is linear. The eye is the
// point on the line from the cascade's centre to the sun at which the depth is `depth.nearest`.
shared::ViewConstants view_of(const SunCascade& cascade, const MapMatrices& matrices, uint32_t size_px,
                              const Axes& axes, const DepthRange& depth) {
    shared::ViewConstants view{};
    const glm::dvec3 eye =
        cascade.center + axes.to_sun * (depth.nearest - glm::dot(cascade.center, axes.to_sun));
    glm::dmat4 to_world(1);
    to_world[0] = glm::dvec4(axes.right, 0);
    to_world[1] = glm::dvec4(-axes.down, 0);
    to_world[2] = glm::dvec4(axes.to_sun, 0);
    to_world[3] = glm::dvec4(eye, 1);
    view.view = glm::mat4(glm::inverse(to_world));
    const glm::dmat4 inverse = glm::inverse(glm::dmat4(matrices.to_clip));
    view.projection = glm::mat4(glm::dmat4(matrices.to_clip) * to_world);
    view.view_projection = view.steady_view_projection = view.prev_view_projection = matrices.to_clip;
    view.inverse_view_projection = glm::mat4(inverse);
    view.eye = glm::vec3(eye);
    view.viewport_px = glm::vec2(static_cast<float>(size_px));
    view.inverse_viewport = 1.0f / view.viewport_px;
    return view;
}

// The sphere that each cascade must cover: its part of the camera's view, or the scene if that is smaller.
// The last cascade contains the whole scene, if the diameter of the scene is at most kMostReach_m. Otherwise
// the last cascade ends at this distance from the eye.
class Parts {
 public:
    Parts(const scene::Camera& camera, double aspect, const scene::Bounds& bounds, uint32_t count)
        : camera_(camera), aspect_(aspect), scene_(sphere_of(bounds)), count_(count) {
        const double reach_m = std::min(2 * scene_.radius_m, kMostReach_m);
        const double near_m = std::min(double{camera.near_m}, reach_m);
        ends_m_ = split_distances(near_m, std::max(reach_m, 1e-3), count);
    }

    [[nodiscard]] Sphere sphere(uint32_t i) const {
        const double from_m = i == 0 ? 0 : ends_m_[i - 1] * (1 - double{shared::kSunBlend});
        const Sphere part = sphere_of_part(camera_, aspect_, from_m, ends_m_[i]);
        return holds_scene(i) || scene_.radius_m < part.radius_m ? scene_ : part;
    }
    [[nodiscard]] double end_m(uint32_t i) const {
        return holds_scene(i) ? std::numeric_limits<double>::infinity() : ends_m_[i];
    }

 private:
    [[nodiscard]] bool holds_scene(uint32_t i) const {
        return i + 1 == count_ && 2 * scene_.radius_m <= kMostReach_m;
    }

    const scene::Camera& camera_;
    double aspect_;
    Sphere scene_;
    uint32_t count_;
    std::array<double, shared::kMostSunCascades> ends_m_{};
};

// Limits a number to 1e30, because Vulkan does not require shaders to support infinite floats.
float finite(double x) {
    return static_cast<float>(std::min(x, 1e30));
}

// Returns the index i if `view` is "sun(i)" or shows this view in a mirror, or kNoId if it is another view.
uint32_t cascade_of(const ResolvedGraph& graph, const std::string& view) {
    for (uint32_t i = 0; i < shared::kMostSunCascades; ++i)
        if (view == sun_view_name(i)) return i;
    const size_t open = view.find('(');
    if (open == std::string::npos) return kNoId;
    const auto list = std::ranges::find(graph.views, view.substr(0, open), &ViewListDecl::name);
    if (list == graph.views.end() || list->source != ViewSource::mirror) return kNoId;
    const unsigned long number = list->first + std::stoul(view.substr(open + 1));
    return cascade_of(graph, list->of + "(" + std::to_string(number) + ")");
}

}  // namespace

std::string sun_view_name(uint32_t cascade) {
    return "sun(" + std::to_string(cascade) + ")";
}

SunMaps sun_maps_of(const FramePlan& plan) {
    SunMaps maps;
    for (const PassDecl& pass : plan.graph.passes) {
        // A debug view draws no shadow map, so it must not change the cascades.
        if (pass.name == kDebugView) continue;
        for (const std::string& view : pass.drawn_views()) {
            const uint32_t i = cascade_of(plan.graph, view);
            if (i == kNoId) continue;
            maps.count = std::max(maps.count, i + 1);
            if (pass.kind == PassKind::raster || pass.kind == PassKind::fullscreen)
                maps.size_px[i] = std::max(maps.size_px[i], pass.state.viewport ? pass.state.viewport->width
                                                                                : pass.render_extent.width);
        }
    }
    return maps;
}

std::array<double, shared::kMostSunCascades> split_distances(double near_m, double far_m, uint32_t count) {
    std::array<double, shared::kMostSunCascades> ends_m{};
    for (uint32_t i = 0; i < count; ++i) {
        const double share = (i + 1.0) / count;
        const double by_ratio = near_m * std::pow(far_m / near_m, share);
        const double by_step = near_m + (far_m - near_m) * share;
        ends_m[i] = kRatioShare * by_ratio + (1 - kRatioShare) * by_step;
    }
    return ends_m;
}

SunCascades sun_cascades(const scene::Camera& camera, float aspect, const SunScene& scene,
                         const SunMaps& maps) {
    SunCascades result;
    const Axes axes = axes_of(scene.to_sun);
    const DepthRange depth = depth_range(scene.bounds, axes.to_sun);
    const Parts parts(camera, aspect, scene.bounds, maps.count);
    result.count = result.constants.count = maps.count;
    result.constants.to_sun = scene.to_sun;
    for (uint32_t i = 0; i < maps.count; ++i) {
        const Sphere sphere = parts.sphere(i);
        const uint32_t size_px = std::max(maps.size_px[i], 1u);
        SunCascade& cascade = result.cascades[i];
        cascade.center = sphere.center;
        cascade.radius_m = sphere.radius_m;
        cascade.end_m = parts.end_m(i);
        cascade.texel_m = 2 * std::max(sphere.radius_m, 1e-3) / std::max(size_px - 2 * kBorderTexels, 1.0);
        const MapMatrices matrices = matrices_of(sphere, cascade.texel_m, size_px, axes, depth);
        cascade.origin_texels = matrices.origin_texels;
        result.constants.cascades[i] = {matrices.to_map, finite(cascade.end_m),
                                        static_cast<float>(cascade.texel_m),
                                        static_cast<float>(depth.nearest - depth.farthest), 0};
        result.views[i] = view_of(cascade, matrices, size_px, axes, depth);
    }
    return result;
}

}  // namespace weft::render
