// Purpose: computes the matrices of views: the faces of a cube, the views of lamps, and views in a mirror.
// Clip space has y down and reversed depth, as shared/frame.glsl describes. Pure functions. Units: metres,
// radians.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "shared/frame.glsl"
#include "shared/light.glsl"
#include "weft/render/frame_input.h"

namespace weft::render {

inline constexpr uint32_t kCubeFaces = 6;

// Returns the view of one face of a cube map, in the order +x −x +y −y +z −z. A point in direction d from
// `at` is drawn to the texel that a samplerCube reads for d. Such a picture is a mirror image, as
// is_mirrored() tells.
[[nodiscard]] ViewInput cube_face(const glm::dvec3& at, uint32_t face, double near_m);

// Returns how many views a lamp has: 1 for a spot light, 6 for a point light, 0 for other lights.
[[nodiscard]] uint32_t count_lamp_views(const shared::Light& light);
// Returns the views of all lamps, in the order of the lights: for a spot light the square that contains its
// cone, for a point light the faces of a cube.
[[nodiscard]] std::vector<ViewInput> lamp_views(std::span<const shared::Light> lights);

// Returns the constants of a view of the program. The previous view is the same view, and viewport_px is 1
// x 1.
[[nodiscard]] shared::ViewConstants constants_of(const ViewInput& view);
// Returns the constants of a view in the mirror with this plane: (a, b, c) is a unit vector, and the points
// with a x + b y + c z + d = 0 are on the mirror. In a perspective view, the mirror is the near plane: depth
// is 1 on the mirror, and everything behind the mirror, as seen from the eye of `view`, is cut off.
[[nodiscard]] shared::ViewConstants mirrored(const shared::ViewConstants& view,
                                             const std::array<double, 4>& plane);

// True if the picture of the view is a mirror image, so that triangles have the opposite winding.
[[nodiscard]] bool is_mirrored(const glm::mat4& view_projection);

}  // namespace weft::render
