// Purpose: draws the probes of a scene: on the left from above, on the right from the side. Light grey: there
// is geometry somewhere along the line of sight. Dark grey: the section through the geometry at the middle of
// the probes. Discs: irradiance probes, their colour tells the level; a black ring marks those that were
// moved. Crosses: grid points without a probe. Squares: reflection probes.
#pragma once

#include <cstdint>
#include <vector>

#include "weft/scene/scene.h"

namespace weft::viewer {

// A picture with four 8-bit channels, encoded for display.
struct ProbePicture {
    uint32_t width_px = 0;
    uint32_t height_px = 0;
    std::vector<uint8_t> rgba;
};

[[nodiscard]] ProbePicture draw_probes(const scene::Scene& scene, const scene::Probes& probes);

}  // namespace weft::viewer
