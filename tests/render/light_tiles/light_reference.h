// What a light reaches, by the definition in shaders/include/shared/light.glsl and in double precision; and
// which lights reach which tile, found pixel by pixel. Shares nothing with the shaders. Units: metres.
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

// Around all that a light reaches; endless if that is without end.
struct BoundingSphere {
    glm::dvec3 center{0};
    double radius_m = 0;
    bool endless = false;
};
[[nodiscard]] BoundingSphere sphere_around(const shared::Light& light);

// What the pixels of a tile show: places in the world, none for the sky.
using TilePlaces = std::vector<std::vector<glm::dvec3>>;  // by tile, in rows
[[nodiscard]] TilePlaces tile_places(const std::vector<float>& depth, Extent3D size,
                                     const shared::ViewConstants& view);

// The lights, from `first` on, that reach a pixel of the tile, ascending.
[[nodiscard]] std::vector<uint32_t> lights_of_tile(const std::vector<glm::dvec3>& places,
                                                   const std::vector<shared::Light>& lights,
                                                   const std::vector<BoundingSphere>& spheres,
                                                   uint32_t first);

}  // namespace weft::test
