// Purpose: angles for scenes that are made in code. Units: radians.
#pragma once

#include <numbers>

namespace weft::scene {

inline constexpr float kPi = std::numbers::pi_v<float>;

}  // namespace weft::scene
