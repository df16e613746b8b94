// Purpose: divides what the camera sees into rectangles in the plane perpendicular to the light, one for each
// shadow map, so that the maps have many texels where the picture has many pixels. Pure functions. Units:
// metres. Source: Lauritzen, Salvi, Lefohn 2011, "Sample Distribution Shadow Maps" (maps that fit the visible
// surfaces).
#pragma once

#include <vector>

#include "render/views/visible_patches.h"

namespace weft::render {

// Returns at most `count` rectangles, from the one with the smallest area to the one with the largest. They
// contain nearly all patches. The few other patches are left to another map, which covers the rectangle
// `whole`. Patches are divided by their position along one axis of the plane or by their distance from the
// eye. Of the divisions that were tried, the result has the largest mean of the logarithm of the texels per
// pixel.
[[nodiscard]] std::vector<LightRect> fit_rects(std::span<const VisiblePatch> patches, uint32_t count,
                                               const LightRect& whole);

}  // namespace weft::render
