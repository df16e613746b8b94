// Purpose: the constant π for angles in radians, used by scenes that are made in code.
#pragma once

#include <numbers>

namespace weft::scene {

inline constexpr float kPi = std::numbers::pi_v<float>;

}  // namespace weft::scene
