// Purpose: estimates on the CPU which surfaces a camera sees, by a grid of rays over its picture. The result
// is the same for all cameras that are close together and look in similar directions. So data that is
// computed from the result changes rarely while a camera moves. Pure functions. Units: metres.
#pragma once

#include <vector>

#include "render/views/light_space.h"
#include "render/views/surface_tree.h"
#include "weft/scene/scene.h"

namespace weft::render {

// The surfaces that a camera may see.
struct SeenScene {
    // Still surfaces. Each tree must outlive this object.
    std::vector<const SurfaceTree*> surfaces;
    // A box with objects whose places are not known, such as those of a draw list of the program. If a ray
    // meets no still surface, such an object may be anywhere on the part of the ray in the box.
    std::optional<scene::Bounds> unknown;
    double reach_m = 0;  // Distance from the eye at which shadows end.
};

// A part of the picture, and the place of the surface in this part: a rectangle in the plane perpendicular to
// the light.
struct VisiblePatch {
    LightRect rect;
    double distance_m = 0;  // From the eye.
    double share = 1;       // Share of a ray.
};

// Returns the camera with the nearest position and direction of a regular grid. Neighbouring positions of the
// grid are `step_m` apart.
[[nodiscard]] scene::Camera rounded_camera(const scene::Camera& camera, double step_m);
// Returns the patches that `camera` sees. `camera` should be the result of rounded_camera(). The rays cover a
// slightly wider picture, so that they also cover what the camera sees before the rounding.
[[nodiscard]] std::vector<VisiblePatch> visible_patches(const scene::Camera& camera, double aspect,
                                                        const SeenScene& seen, const LightAxes& axes);

}  // namespace weft::render
