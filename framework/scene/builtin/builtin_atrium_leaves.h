// Purpose: distributes leaf cards for trees and climbing plants.
#pragma once

#include "scene/procedural/procedural_mesh.h"
#include "scene/procedural/procedural_noise.h"

namespace weft::scene::atrium {

// A uniformly distributed direction.
[[nodiscard]] glm::vec3 on_sphere(Random& random);

// A card whose front faces `facing`, rotated around that direction by `roll_rad`. `half` is half of its side
// length.
[[nodiscard]] Card facing_card(glm::vec3 center, glm::vec3 facing, float roll_rad, float half_m);

}  // namespace weft::scene::atrium
