// Purpose: makes the small picture of the surroundings that lights a scene (Environment::light).
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>

#include "weft/scene/environment.h"

namespace weft::scene {

// Largest size of the picture. Larger pictures are made smaller.
inline constexpr uint32_t kMostLightWidth_px = 1024, kMostLightHeight_px = 512;

// Makes the picture from radiance in cd/m²: width_px × height_px texels, all finite and not negative.
[[nodiscard]] LightPicture light_picture(uint32_t width_px, uint32_t height_px,
                                         std::span<const glm::vec3> radiance);

}  // namespace weft::scene
