// Purpose: finds the suns in a picture of the surroundings and takes them out of it. A sun is a small region
// of very bright texels. The scene gets a directional light for each sun, because a light gives sharp
// highlights and shadows, which filtered pictures cannot give. Picture: equirectangular, as in Environment.
//
// A region is a set of connected texels whose luminance is more than 30 times the median of the picture,
// weighted by solid angle. Texels are connected across the left and right border and over the poles. A region
// is a sun if
//   - its light is more than 2 % of the light of the picture. Light: luminance, integrated over the sphere,
//     less the luminance of the region's surroundings;
//   - its light comes from a spot of at most 10° radius; larger sources cast shadows too soft for a light;
//   - it is not elongated: a rectangle of up to about 3.5 : 1 is a sun, a line or a bright horizon is not;
//   - it looks like a uniform disc, or its radius is at most 2° or 2.5 texels. A light has the highlight of a
//     disc, so the highlights of other large shapes would be wrong.
// A region that has enough light but is not a sun may contain a sun. So higher thresholds are tried for the
// texels of this region, and the smaller regions that they give are tested in the same way. At most 16 suns
// are taken out, those with the most light. All other regions stay in the picture.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "weft/scene/environment.h"

namespace weft::scene {

inline constexpr size_t kMostSuns = 16;

// Returns the suns, the one with the largest illuminance first. Replaces the texels of each sun by the median
// of the texels around it, separately for each channel. Channels that are negative or not finite become 0.
// The time is proportional to the number of texels. A picture with bright regions takes at most 32 times as
// long as a picture of the same size without them.
[[nodiscard]] std::vector<PictureSun> extract_suns(uint32_t width_px, uint32_t height_px,
                                                   std::span<glm::vec3> radiance);

}  // namespace weft::scene
