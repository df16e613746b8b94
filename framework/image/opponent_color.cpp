#include "image/opponent_color.h"

#include <cmath>

namespace weft::image {
namespace {

// Converts linear Rec.709 colours to XYZ. The three columns are the contributions of red, green and blue.
// White has the chromaticity x = 0.3127, y = 0.3290 (D65).
const glm::mat3 kToXyz{{0.4123908f, 0.2126390f, 0.0193308f},
                       {0.3575843f, 0.7151687f, 0.1191948f},
                       {0.1804808f, 0.0721923f, 0.9505322f}};
const glm::mat3 kFromXyz = glm::inverse(kToXyz);
const glm::vec3 kWhite = kToXyz * glm::vec3(1);

float lab_curve(float t) {
    constexpr float kKnee = 6.0f / 29.0f;
    return t > kKnee * kKnee * kKnee ? std::cbrt(t) : t / (3 * kKnee * kKnee) + 4.0f / 29.0f;
}

}  // namespace

glm::vec3 linear_to_ycxcz(glm::vec3 rgb) {
    const glm::vec3 xyz = kToXyz * rgb / kWhite;
    return {116 * xyz.y - 16, 500 * (xyz.x - xyz.y), 200 * (xyz.y - xyz.z)};
}

glm::vec3 ycxcz_to_linear(glm::vec3 ycxcz) {
    const float y = (ycxcz.x + 16) / 116;
    return kFromXyz * (glm::vec3(y + ycxcz.y / 500, y, y - ycxcz.z / 200) * kWhite);
}

glm::vec3 linear_to_hunt_lab(glm::vec3 rgb) {
    const glm::vec3 xyz = kToXyz * rgb / kWhite;
    const float x = lab_curve(xyz.x), y = lab_curve(xyz.y), z = lab_curve(xyz.z);
    const float lightness = 116 * y - 16;
    const float chroma = 0.01f * lightness;
    return {lightness, chroma * 500 * (x - y), chroma * 200 * (y - z)};
}

float hyab_distance(glm::vec3 lab_a, glm::vec3 lab_b) {
    const glm::vec3 d = lab_a - lab_b;
    return std::abs(d.x) + std::hypot(d.y, d.z);
}

}  // namespace weft::image
