// Purpose: distributes leaf cards for trees and climbing plants.
#pragma once

#include "scene/procedural/procedural_mesh.h"
#include "scene/procedural/procedural_noise.h"

namespace weft::scene::atrium {

// Returns a random direction; all directions are equally probable.
[[nodiscard]] glm::vec3 on_sphere(Random& random);

// Returns a square leaf card whose front faces the direction `facing`. The card is rotated around this
// direction by `roll_rad`. `half_m` is half of its side length.
[[nodiscard]] Card facing_card(glm::vec3 center, glm::vec3 facing, float roll_rad, float half_m);

}  // namespace weft::scene::atrium
