// Purpose: decodes octahedral normals, and computes the light of point, spot and directional lights at a
// point, in double precision. Distance window and cones follow KHR_lights_punctual.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "shared/light.glsl"

namespace weft::test {

inline glm::dvec3 octahedral_normal(const glm::vec4& e) {
    glm::dvec3 n(e.x, e.y, 1 - std::abs(e.x) - std::abs(e.y));
    if (n.z < 0) {
        const double x = n.x, y = n.y;
        n.x = (1 - std::abs(y)) * (x >= 0 ? 1 : -1);
        n.y = (1 - std::abs(x)) * (y >= 0 ? 1 : -1);
    }
    return glm::normalize(n);
}

// Returns the irradiance on a plane that faces the light, and sets `l` to the direction from the point `at`
// towards the light.
inline glm::dvec3 incident(const shared::Light& light, const glm::dvec3& at, glm::dvec3& l) {
    if (light.type == shared::kLightDirectional) {
        l = -glm::dvec3(light.direction);
        return glm::dvec3(light.intensity);
    }
    const glm::dvec3 d = glm::dvec3(light.position) - at;
    const double distance2 = glm::dot(d, d);
    l = d / std::sqrt(distance2);
    double falloff = 1 / distance2;
    if (light.range_m > 0)
        falloff *= std::clamp(1 - std::pow(std::sqrt(distance2) / light.range_m, 4), 0.0, 1.0);
    if (light.type == shared::kLightSpot) {
        const double cone = std::clamp(
            glm::dot(glm::dvec3(light.direction), -l) * light.cone_scale + light.cone_offset, 0.0, 1.0);
        falloff *= cone * cone;
    }
    return glm::dvec3(light.intensity) * falloff;
}

}  // namespace weft::test
