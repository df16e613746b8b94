// Purpose: estimates on the CPU which surfaces a camera sees, by a grid of rays over its picture. The result
// is the same for all cameras that are close together and look in similar directions. So what is computed
// from it changes rarely while a camera moves. Pure functions. Units: metres.
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
    // A box with objects whose places are not known, such as those of a draw list of the program. Rays that
    // meet no still surface look for them in the whole box.
    std::optional<scene::Bounds> unknown;
    double reach_m = 0;  // Distance from the eye at which shadows end.
};

// A part of the picture: the place of its surface in the plane perpendicular to the light.
struct VisiblePatch {
    LightRect rect;
    double distance_m = 0;  // From the eye.
    double share = 1;       // Share of a ray.
};

// Returns the camera at the nearest of a regular grid of positions and directions. The grid of positions has
// the width `step_m`.
[[nodiscard]] scene::Camera rounded_camera(const scene::Camera& camera, double step_m);
// Returns the patches that `camera` sees. It should be the result of rounded_camera(); the picture is seen as
// a little wider, so that it contains what the camera sees before the rounding.
[[nodiscard]] std::vector<VisiblePatch> visible_patches(const scene::Camera& camera, double aspect,
                                                        const SeenScene& seen, const LightAxes& axes);

}  // namespace weft::render
