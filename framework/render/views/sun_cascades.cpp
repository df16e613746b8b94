#include "render/views/sun_cascades.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "graph/parse/debug_view.h"
#include "render/views/sun_fit.h"

namespace weft::render {
namespace {

static_assert(sizeof(shared::SunCascade) == 80 && sizeof(shared::SunConstants) == 336);

// Maximum distance from the eye at which shadows are drawn, in metres. It applies only if the diameter of the
// scene is larger than this value.
constexpr double kMostReach_m = 250;
// Width in texels of the border between the rectangle that a map must cover and the edge of the map. The
// border has room for the radius of the filter, the offset along the normal, most of the band in which a map
// is blended with the next one, and half a texel for snapping to whole texels.
constexpr double kBorderTexels = 8;
// The size of a texel is rounded up to a power of 2^(1 / kSizeSteps), so that it changes rarely while the
// camera moves.
constexpr double kSizeSteps = 4;
// Largest ratio of the sides of a texel.
constexpr double kMostStretch = 4;
// The least side of a rectangle that a map covers, in metres.
constexpr double kLeastSide_m = 1e-3;
// The eye is rounded to steps of this share of the scene's radius, but at most kMostStep_m metres.
constexpr double kStepShare = 1.0 / 64, kMostStep_m = 0.25;
// Margin beyond the scene's bounds, relative to their depth, so that rounding does not cut off objects on the
// bounds.
constexpr double kDepthMargin = 0.01;

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

// Returns a point on the line through the middle of the rectangle, in the direction of the light.
glm::dvec3 middle_of(const LightRect& rect, const LightAxes& axes) {
    const glm::dvec2 middle = (rect.min + rect.max) * 0.5;
    return axes.right * middle.x + axes.down * middle.y;
}

// The matrices of one cascade. The axes are rounded to float first, and do not depend on the position and
// direction of the camera. The origin is a whole number of texels, which a float represents exactly. So if
// the camera moves, the map moves by exactly whole texels, and static shadows do not flicker.
struct MapMatrices {
    glm::mat4 to_map{0}, to_clip{0};
    glm::dvec2 origin_texels{0};
};

MapMatrices matrices_of(const SunCascade& cascade, uint32_t size_px, const LightAxes& axes,
                        const DepthRange& depth) {
    const glm::dvec2 side_m = cascade.texel_m * double(size_px);
    const std::array<glm::vec3, 2> across{glm::vec3(axes.right / side_m.x), glm::vec3(axes.down / side_m.y)};
    const glm::dvec3 center = middle_of(cascade.rect, axes);
    MapMatrices matrices;
    for (int row = 0; row < 2; ++row) {
        const glm::vec3& axis = across[static_cast<size_t>(row)];
        const double center_texels = glm::dot(glm::dvec3(axis), center) * size_px;
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
// point on the line from the middle of the map's rectangle to the sun at which the depth is `depth.nearest`.
shared::ViewConstants view_of(const SunCascade& cascade, const MapMatrices& matrices, uint32_t size_px,
                              const LightAxes& axes, const DepthRange& depth) {
    shared::ViewConstants view{};
    const glm::dvec3 eye = middle_of(cascade.rect, axes) + axes.to_sun * depth.nearest;
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

double diameter_of(const scene::Bounds& bounds) {
    return glm::length(glm::dvec3(bounds.max) - glm::dvec3(bounds.min));
}

// The largest distance from the eye to a point of the box.
double farthest_of(const scene::Bounds& box, const glm::dvec3& eye) {
    return glm::length(glm::max(glm::abs(glm::dvec3(box.min) - eye), glm::abs(glm::dvec3(box.max) - eye)));
}

// The part of the scene that the camera sees. `camera` is the result of rounded_camera(), which rounds the
// position and the direction. So these data change rarely while the camera moves.
struct Sight {
    scene::Camera camera;
    SeenScene seen;
    double end_m =
        0;  // Distance from the eye at which shadows end. Infinite if all of the scene has shadows.
};

// Returns the size in metres of the steps to which the position of the eye is rounded.
double step_of(const SunScene& scene) {
    if (scene.is_unbounded) return kMostStep_m;
    return std::clamp(diameter_of(scene.bounds) * 0.5 * kStepShare, kLeastSide_m, kMostStep_m);
}

// If there are objects that may be anywhere, extends the bounds of the scene to kMostReach_m around the eye.
// Farther away from the eye, these objects have no shadows.
SunScene with_bounds(const SunScene& scene, const glm::vec3& eye) {
    SunScene bounded = scene;
    if (!scene.is_unbounded) return bounded;
    const auto reach_m = static_cast<float>(kMostReach_m);
    bounded.bounds = {glm::min(scene.bounds.min, eye - reach_m), glm::max(scene.bounds.max, eye + reach_m)};
    bounded.unknown = bounded.bounds;
    return bounded;
}

// `camera` is the result of rounded_camera().
Sight sight_of(const scene::Camera& camera, const SunScene& scene) {
    Sight sight;
    sight.camera = camera;
    const bool is_large = diameter_of(scene.bounds) > kMostReach_m;
    sight.end_m = is_large ? kMostReach_m : std::numeric_limits<double>::infinity();
    sight.seen.reach_m = is_large ? kMostReach_m : farthest_of(scene.bounds, glm::dvec3(camera.transform[3]));
    sight.seen.surfaces = scene.surfaces;
    sight.seen.unknown = scene.unknown;
    return sight;
}

// The rectangle of the last map. It covers the whole part of the scene that has shadows. This includes
// objects that the camera does not see, because other views may show them, and small objects, because the
// rays of visible_patches() miss them.
LightRect whole_rect(const SunScene& scene, const Sight& sight, const LightAxes& axes) {
    glm::dvec3 least(scene.bounds.min), most(scene.bounds.max);
    if (std::isfinite(sight.end_m)) {
        const glm::dvec3 eye(sight.camera.transform[3]);
        const double reach_m = sight.end_m + kMostStep_m;
        least = glm::clamp(least, eye - reach_m, eye + reach_m);
        most = glm::clamp(most, eye - reach_m, eye + reach_m);
    }
    LightRect rect;
    for (int corner = 0; corner < 8; ++corner)
        rect.add(axes.place({(corner & 1) != 0 ? most.x : least.x, (corner & 2) != 0 ? most.y : least.y,
                             (corner & 4) != 0 ? most.z : least.z}));
    return rect;
}

double rounded_up(double size) {
    return std::exp2(std::ceil(std::log2(size) * kSizeSteps - 1e-9) / kSizeSteps);
}

glm::dvec2 texel_for(const LightRect& rect, uint32_t size_px) {
    const glm::dvec2 size =
        glm::max(rect.size(), glm::dvec2(kLeastSide_m)) / std::max(size_px - 2 * kBorderTexels, 1.0);
    const glm::dvec2 texel(rounded_up(size.x), rounded_up(size.y));
    return glm::max(texel, glm::dvec2(texel.y, texel.x) / kMostStretch);
}

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

SunCascades sun_cascades(const scene::Camera& camera, float aspect, const SunScene& given,
                         const SunMaps& maps) {
    SunCascades result;
    result.count = result.constants.count = maps.count;
    result.constants.to_sun = given.to_sun;
    if (maps.count == 0) return result;
    const scene::Camera rounded = rounded_camera(camera, step_of(given));
    const SunScene scene = with_bounds(given, glm::vec3(rounded.transform[3]));
    const LightAxes axes = light_axes(scene.to_sun);
    const DepthRange depth = depth_range(scene.bounds, axes.to_sun);
    const Sight sight = sight_of(rounded, scene);
    const LightRect whole = whole_rect(scene, sight, axes);
    std::vector<LightRect> rects;
    if (maps.count > 1)
        rects =
            fit_rects(visible_patches(sight.camera, double{aspect}, sight.seen, axes), maps.count - 1, whole);
    rects.resize(maps.count, whole);
    for (uint32_t i = 0; i < maps.count; ++i) {
        const uint32_t size_px = std::max(maps.size_px[i], 1u);
        SunCascade& cascade = result.cascades[i];
        cascade.rect = rects[i];
        cascade.texel_m = texel_for(rects[i], size_px);
        const MapMatrices matrices = matrices_of(cascade, size_px, axes, depth);
        cascade.origin_texels = matrices.origin_texels;
        result.constants.cascades[i] = {matrices.to_map, glm::vec2(cascade.texel_m),
                                        static_cast<float>(depth.nearest - depth.farthest),
                                        finite(sight.end_m)};
        result.views[i] = view_of(cascade, matrices, size_px, axes, depth);
    }
    return result;
}

const SunCascades& SunCascadesCache::find(const scene::Camera& camera, float aspect, const SunScene& scene,
                                          const SunMaps& maps, uint64_t surfaces_version) {
    const scene::Camera rounded = rounded_camera(camera, step_of(scene));
    std::vector<float> key{aspect, rounded.fov_y_rad, rounded.near_m, scene.is_unbounded ? 1.0f : 0.0f,
                           static_cast<float>(maps.count)};
    const auto add = [&](const glm::vec3& v) { key.insert(key.end(), {v.x, v.y, v.z}); };
    for (int column = 0; column < 4; ++column) add(glm::vec3(rounded.transform[column]));
    for (const uint32_t size_px : maps.size_px) key.push_back(static_cast<float>(size_px));
    add(scene.to_sun), add(scene.bounds.min), add(scene.bounds.max);
    if (scene.unknown) add(scene.unknown->min), add(scene.unknown->max);
    if (key != key_ || surfaces_version != surfaces_version_)
        cascades_ = sun_cascades(camera, aspect, scene, maps);
    key_ = std::move(key);
    surfaces_version_ = surfaces_version;
    return cascades_;
}

}  // namespace weft::render
