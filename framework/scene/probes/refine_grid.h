// Purpose: the two ways in which a scene gets its grid of irradiance probes. A small scene gets cells near
// all of its surfaces; cells are split where they are too coarse. A large scene gets three nested levels of
// cells around a camera.
#pragma once

#include <optional>

#include "scene/probes/probe_grid.h"
#include "weft/scene/place_probes.h"

namespace weft::scene {

// The largest spacing of probes near objects, and the largest spacing on open ground. Unit: the smallest
// spacing of the grid.
inline constexpr int kObjectStride = 4;
inline constexpr int kGroundStride = 32;

// Returns nullopt if the whole scene needs more than three quarters of the permitted probes even with the
// coarsest cells.
[[nodiscard]] std::optional<ProbeVolume> fit_volume(const TriangleTree& tree, const PlacementParams& params,
                                                    uint32_t threads);
// `origin`: the place of grid point (0, 0, 0).
[[nodiscard]] ProbeVolume surround_camera(const TriangleTree& tree, const glm::vec3& origin,
                                          const PlacementParams& params, uint32_t threads);

}  // namespace weft::scene
