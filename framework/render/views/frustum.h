// Purpose: tests whether a box is outside of the frustum of a view, so that draws that cannot change the
// picture are left out. The tests allow for rounding: a box near a plane counts as inside. Pure functions.
#pragma once

#include <array>
#include <vector>

#include "shared/frame.glsl"
#include "weft/scene/scene.h"

namespace weft::render {

// The planes of a view: points with dot(plane, (x, y, z, 1)) < 0 are outside. If a view has no far plane, no
// point is outside of its last plane.
struct Frustum {
    std::array<glm::dvec4, 6> planes;
};
[[nodiscard]] Frustum frustum_of(const shared::ViewConstants& view);

// Returns the box around a mesh in world space, with a margin for the rounding of the positions on the GPU.
[[nodiscard]] scene::Bounds box_in_world(const scene::Bounds& box, const glm::mat4& to_world);

// Returns true if the whole box is outside of one plane. If `depth_clamp` is true, the near and the far plane
// are left out, because then geometry before and behind them is drawn.
[[nodiscard]] bool is_outside(const Frustum& frustum, const scene::Bounds& box, bool depth_clamp);

// The frustums of all views that a draw is recorded for.
using Frusta = std::vector<const Frustum*>;
// Returns true if the box is outside of every frustum. Without frustums, nothing is outside.
[[nodiscard]] bool is_outside(const Frusta& frusta, const scene::Bounds& box, bool depth_clamp);

}  // namespace weft::render
