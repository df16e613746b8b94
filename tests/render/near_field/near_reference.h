// Purpose: what a point of a scene of boxes sees of the surroundings, by tracing rays: the reference for the
// near field.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace weft::test {

struct Box {
    glm::dvec3 least{0}, most{0};
};

struct Openness {
    double visibility = 0;    // Share of the irradiance of a uniform sky that arrives.
    glm::dvec3 direction{0};  // Mean direction of this light, weighted by the cosine.
};

// Traces stratified rays from a point with the normal +y, distributed by the cosine.
Openness openness_of(const glm::dvec3& point, const std::vector<Box>& boxes);

}  // namespace weft::test
