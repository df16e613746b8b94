// Purpose: reference for light culling in double precision, after the definition in
// shaders/include/shared/light.glsl. It computes whether a light reaches a point, and finds the lights of
// each tile pixel by pixel. It shares no code with the shaders. Units: metres.
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

// A sphere around the region that a light reaches. `endless` is true if the region is infinite.
struct BoundingSphere {
    glm::dvec3 center{0};
    double radius_m = 0;
    bool endless = false;
};
[[nodiscard]] BoundingSphere sphere_around(const shared::Light& light);

// World positions of the surface points in the pixels of each tile. Pixels that show the sky have none.
using TilePlaces = std::vector<std::vector<glm::dvec3>>;  // one element per tile, row by row
[[nodiscard]] TilePlaces tile_places(const std::vector<float>& depth, Extent3D size,
                                     const shared::ViewConstants& view);

// Returns the indices of the lights that reach a pixel of the tile, in ascending order. Lights before index
// `first` are left out.
[[nodiscard]] std::vector<uint32_t> lights_of_tile(const std::vector<glm::dvec3>& places,
                                                   const std::vector<shared::Light>& lights,
                                                   const std::vector<BoundingSphere>& spheres,
                                                   uint32_t first);

}  // namespace weft::test
