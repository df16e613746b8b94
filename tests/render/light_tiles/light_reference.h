// A reference for light culling in double precision, by the definition in shaders/include/shared/light.glsl:
// the light at a point, and the lights that reach each tile, found pixel by pixel. Shares no code with the
// shaders. Units: metres.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "shared/frame.glsl"
#include "shared/light.glsl"
#include "weft/declaration.h"

namespace weft::test {

inline constexpr uint32_t kTilePx = 16;

[[nodiscard]] bool reaches(const shared::Light& light, const glm::dvec3& place);

// A sphere around the region that a light reaches; infinite if the region is.
struct BoundingSphere {
    glm::dvec3 center{0};
    double radius_m = 0;
    bool endless = false;
};
[[nodiscard]] BoundingSphere sphere_around(const shared::Light& light);

// World positions of the surfaces in the pixels of a tile; empty for sky.
using TilePlaces = std::vector<std::vector<glm::dvec3>>;  // tiles in row order
[[nodiscard]] TilePlaces tile_places(const std::vector<float>& depth, Extent3D size,
                                     const shared::ViewConstants& view);

// The lights, from index `first` on, that reach a pixel of the tile, in ascending order.
[[nodiscard]] std::vector<uint32_t> lights_of_tile(const std::vector<glm::dvec3>& places,
                                                   const std::vector<shared::Light>& lights,
                                                   const std::vector<BoundingSphere>& spheres,
                                                   uint32_t first);

}  // namespace weft::test
