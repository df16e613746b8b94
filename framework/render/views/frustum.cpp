#include "render/views/frustum.h"

#include <algorithm>
#include <cmath>

namespace weft::render {
namespace {

// Share by which the sides of the frustum are wider than the picture, and the additional width in pixels. The
// rasteriser rounds positions to parts of a pixel, and a pass may draw fewer pixels than the view has.
constexpr double kWiderShare = 0.01, kWiderPx = 4;
// Bound for the rounding error of a sum, as a share of the sum of the absolute values of its terms. It holds
// for positions in world space and for distances from the planes.
constexpr double kRounding = 1e-5;
constexpr size_t kSidePlanes = 4;

}  // namespace

Frustum frustum_of(const shared::ViewConstants& view) {
    const glm::dmat4 m = glm::transpose(glm::dmat4(view.view_projection));
    const glm::dvec4 wide_x = m[3] * (1 + kWiderShare + kWiderPx / std::max<double>(view.viewport_px.x, 1));
    const glm::dvec4 wide_y = m[3] * (1 + kWiderShare + kWiderPx / std::max<double>(view.viewport_px.y, 1));
    return {{wide_x + m[0], wide_x - m[0], wide_y + m[1], wide_y - m[1], m[3] - m[2], m[2]}};
}

scene::Bounds box_in_world(const scene::Bounds& box, const glm::mat4& to_world) {
    scene::Bounds world;
    for (int row = 0; row < 3; ++row) {
        double least = to_world[3][row], most = least, terms = std::abs(least);
        for (int column = 0; column < 3; ++column) {
            const double a = double{to_world[column][row]} * double{box.min[column]};
            const double b = double{to_world[column][row]} * double{box.max[column]};
            least += std::min(a, b), most += std::max(a, b);
            terms += std::max(std::abs(a), std::abs(b));
        }
        world.min[row] = static_cast<float>(least - terms * kRounding);
        world.max[row] = static_cast<float>(most + terms * kRounding);
    }
    return world;
}

// For each plane, the function tests only the corner of the box that lies farthest inside.
bool is_outside(const Frustum& frustum, const scene::Bounds& box, bool depth_clamp) {
    for (size_t i = 0; i < (depth_clamp ? kSidePlanes : frustum.planes.size()); ++i) {
        const glm::dvec4& plane = frustum.planes[i];
        double inside = plane.w, terms = std::abs(plane.w);
        for (int axis = 0; axis < 3; ++axis) {
            const double a = plane[axis] * double{box.min[axis]}, b = plane[axis] * double{box.max[axis]};
            inside += std::max(a, b);
            terms += std::max(std::abs(a), std::abs(b));
        }
        if (inside < -terms * kRounding) return true;
    }
    return false;
}

bool is_outside(const Frusta& frusta, const scene::Bounds& box, bool depth_clamp) {
    return !frusta.empty() && std::ranges::all_of(frusta, [&](const Frustum* frustum) {
        return is_outside(*frustum, box, depth_clamp);
    });
}

}  // namespace weft::render
