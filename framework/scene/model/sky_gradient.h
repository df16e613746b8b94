// Purpose: the gradient sky of a scene without an environment picture. The function gradient_radiance() of
// sky.glsl computes the same. Units: cd/m².
#pragma once

#include <glm/glm.hpp>

namespace weft::scene {

// The ground below the sky has the radiance of the horizon, multiplied by this factor.
inline constexpr float kGroundAlbedo = 0.25f;

struct SkyGradient {
    glm::vec3 zenith{0};
    glm::vec3 horizon{0};
};

// Returns the radiance that comes from `direction`, a unit vector.
[[nodiscard]] inline glm::vec3 gradient_radiance(const SkyGradient& sky, const glm::vec3& direction) {
    if (direction.y < 0)
        return glm::mix(sky.horizon, sky.horizon * kGroundAlbedo, glm::smoothstep(0.0f, 0.15f, -direction.y));
    return glm::mix(sky.horizon, sky.zenith, glm::sqrt(direction.y));
}

}  // namespace weft::scene
