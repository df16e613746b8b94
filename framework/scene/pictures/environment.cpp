#include "weft/scene/environment.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/packing.hpp>
#include <limits>
#include <numbers>

#include "scene/pictures/light_picture.h"
#include "scene/pictures/picture_level.h"

namespace weft::scene {
namespace {

// Largest width in texels of the mip level that beams_of() converts to beams: directions with their light.
constexpr uint32_t kBeamColumns = 32;

// The integrals of one row of texels along the azimuth. The integral of a basis function over a texel is a
// product: an integral over the azimuth times an integral over the polar angle.
struct RowIntegrals {
    // Each vector is the integral of radiance × f(a) over the azimuth a of the row. f(a) is 1, sin a, cos a,
    // sin 2a or cos 2a.
    glm::dvec3 one{0}, sine{0}, cosine{0}, sine_twice{0}, cosine_twice{0};
};

RowIntegrals integrate_row(std::span<const glm::vec3> row) {
    RowIntegrals sums;
    const double step = 2 * std::numbers::pi / double(row.size());
    // The integral of sin(a) over a texel of width `step` is sin(a) at the middle of the texel times 2
    // sin(step / 2). The same holds for cos(a); for sin(2a) and cos(2a) the factor is sin(step).
    const double once = 2 * std::sin(step / 2), twice = std::sin(step);
    for (size_t x = 0; x < row.size(); ++x) {
        const double azimuth = (double(x) + 0.5) * step - std::numbers::pi;
        const glm::dvec3 radiance(row[x]);
        const double s = std::sin(azimuth), c = std::cos(azimuth);
        sums.one += radiance * step;
        sums.sine += radiance * (s * once);
        sums.cosine += radiance * (c * once);
        sums.sine_twice += radiance * (2 * s * c * twice);
        sums.cosine_twice += radiance * ((c * c - s * s) * twice);
    }
    return sums;
}

// Adds one row of texels to the moments. moments[i] is the integral of radiance × environment_basis()[i] over
// the sphere. The row covers the polar angles from begin_rad to end_rad.
// For the azimuth a and the polar angle θ, a direction is (sin θ · sin a, cos θ, −sin θ · cos a).
void add_row(std::array<glm::dvec3, 9>& moments, const RowIntegrals& row, double begin_rad, double end_rad) {
    const auto between = [&](auto antiderivative) {
        return antiderivative(std::cos(end_rad), std::sin(end_rad), end_rad) -
               antiderivative(std::cos(begin_rad), std::sin(begin_rad), begin_rad);
    };
    const double sin1 = between([](double c, double, double) { return -c; });
    const double sin_cos = between([](double, double s, double) { return s * s / 2; });
    const double sin2 = between([](double c, double s, double t) { return (t - s * c) / 2; });
    const double sin2_cos = between([](double, double s, double) { return s * s * s / 3; });
    const double sin3 = between([](double c, double, double) { return c * c * c / 3 - c; });
    const double zonal = between([](double c, double, double) { return c - c * c * c; });
    moments[0] += row.one * sin1;
    moments[1] += row.sine * sin2;
    moments[2] += row.one * sin_cos;
    moments[3] -= row.cosine * sin2;
    moments[4] += row.sine * sin2_cos;
    moments[5] -= row.cosine * sin2_cos;
    moments[6] -= row.sine_twice * (sin3 / 2);
    moments[7] += row.one * zonal;
    moments[8] -= row.cosine_twice * sin3;
}

std::array<glm::vec3, 9> irradiance_over_pi(uint32_t width_px, uint32_t height_px,
                                            std::span<const glm::vec3> texels) {
    std::array<glm::dvec3, 9> moments{};
    for (uint32_t y = 0; y < height_px; ++y)
        add_row(moments, integrate_row(texels.subspan(size_t{y} * width_px, width_px)),
                std::numbers::pi * y / height_px, std::numbers::pi * (y + 1) / height_px);
    // Factors of the nine harmonics. Each is the product of two numbers: the square of the normalisation
    // factor of the harmonic, and the factor by which a cosine lobe scales the harmonics of this order. For
    // the orders 0, 1 and 2, the second number is 1, 2/3 and 1/4.
    constexpr double k0 = 1 / (4 * std::numbers::pi), k1 = 3 / (4 * std::numbers::pi) * 2 / 3,
                     k2 = 15 / (4 * std::numbers::pi) / 4;
    constexpr std::array<double, 9> kFactors{k0, k1, k1, k1, k2, k2, k2, k2 / 12, k2 / 4};
    std::array<glm::vec3, 9> coefficients{};
    for (size_t i = 0; i < coefficients.size(); ++i) coefficients[i] = glm::vec3(moments[i] * kFactors[i]);
    return coefficients;
}

struct Beam {
    glm::dvec3 direction{0};
    glm::dvec3 flux{0};  // Radiance of one texel times the solid angle of the texel.
};

// Converts a mip level to beams. Each beam has the direction of a texel and the light from this texel. The
// level has at most kBeamColumns columns, which is enough to show the directions of the light.
std::vector<Beam> beams_of(const PictureLevel& level) {
    std::vector<Beam> beams;
    for (uint32_t y = 0; y < level.height_px; ++y) {
        const double top = std::numbers::pi * y / level.height_px,
                     bottom = std::numbers::pi * (y + 1) / level.height_px;
        const double polar = (top + bottom) / 2;
        const double angle = (std::cos(top) - std::cos(bottom)) * 2 * std::numbers::pi / level.width_px;
        for (uint32_t x = 0; x < level.width_px; ++x) {
            const double azimuth = ((x + 0.5) / level.width_px - 0.5) * 2 * std::numbers::pi;
            beams.push_back(
                {{std::sin(polar) * std::sin(azimuth), std::cos(polar), -std::sin(polar) * std::cos(azimuth)},
                 glm::dvec3(level.texels[size_t{y} * level.width_px + x]) * angle});
        }
    }
    return beams;
}

// Number of directions that side(i) returns: 8 rings with 16 directions each, spread over the whole sphere.
constexpr int kSides = 128;
glm::dvec3 side(int i) {
    constexpr int kColumns = 16;
    const double polar = std::numbers::pi * (i / kColumns + 0.5) * kColumns / kSides,
                 azimuth = 2 * std::numbers::pi * (i % kColumns) / kColumns;
    return {std::sin(polar) * std::sin(azimuth), std::cos(polar), -std::sin(polar) * std::cos(azimuth)};
}

// Returns the smallest value of irradiance / π over 128 directions, separately for each colour channel.
glm::dvec3 darkest_side(const std::vector<Beam>& beams) {
    glm::dvec3 least(std::numeric_limits<double>::max());
    for (int i = 0; i < kSides; ++i) {
        glm::dvec3 sent(0);
        for (const Beam& beam : beams) sent += beam.flux * std::max(0.0, glm::dot(side(i), beam.direction));
        least = glm::min(least, sent / std::numbers::pi);
    }
    return least;
}

// Returns true if the irradiance / π that the harmonics give is at least `least` in all directions side(i).
bool nowhere_below(const std::array<glm::vec3, 9>& coefficients, const glm::dvec3& least) {
    for (int i = 0; i < kSides; ++i) {
        const std::array<float, 9> basis = environment_basis(glm::vec3(side(i)));
        glm::dvec3 found(0);
        for (size_t k = 0; k < basis.size(); ++k) found += glm::dvec3(coefficients[k]) * double(basis[k]);
        if (glm::any(glm::lessThan(found, least))) return false;
    }
    return true;
}

// If a picture has a small bright sun, the sum of harmonics of three orders can be negative in directions
// that face away from the sun. Clamping each colour channel to zero there would give wrong colours. So the
// coefficients are multiplied by a window that reduces the orders 1 and 2 only as much as needed: P.-P.
// Sloan, "Deringing Spherical Harmonics", 2017.
std::array<glm::vec3, 9> without_ringing(const std::array<glm::vec3, 9>& coefficients,
                                         const PictureLevel& level) {
    // The window is strong enough if the sum of harmonics is at least this share of the smallest exact
    // irradiance in all 128 directions side(i).
    constexpr double kMostOfIt = 0.7;
    const glm::dvec3 least = darkest_side(beams_of(level)) * kMostOfIt;
    std::array<glm::vec3, 9> calm = coefficients;
    for (float strength = 0.002f; strength < 10 && !nowhere_below(calm, least); strength *= 1.5f) {
        const float first = 1 / (1 + 4 * strength), second = 1 / (1 + 36 * strength);
        for (size_t i = 1; i < calm.size(); ++i) calm[i] = coefficients[i] * (i < 4 ? first : second);
    }
    return calm;
}

// Returns Environment::irradiance_over_pi for a picture: the coefficients of the harmonics after
// without_ringing().
std::array<glm::vec3, 9> calm_irradiance_over_pi(uint32_t width_px, uint32_t height_px,
                                                 std::span<const glm::vec3> texels) {
    const std::array<glm::vec3, 9> coefficients = irradiance_over_pi(width_px, height_px, texels);
    PictureLevel level{width_px, height_px, {}};
    do {
        if (level.width_px <= 1 && level.height_px <= 1) return coefficients;
        level = half_of(level.width_px, level.height_px, texels);
        texels = level.texels;
    } while (level.width_px > kBeamColumns);
    return without_ringing(coefficients, level);
}

}  // namespace

Environment build_environment(uint32_t width_px, uint32_t height_px, std::span<const glm::vec3> radiance) {
    return build_environment(width_px, height_px, radiance, radiance);
}

Environment build_environment(uint32_t width_px, uint32_t height_px, std::span<const glm::vec3> radiance,
                              std::span<const glm::vec3> without_suns) {
    Environment environment;
    environment.width_px = width_px;
    environment.height_px = height_px;
    environment.scale = stored_scale(radiance);
    environment.irradiance_over_pi = calm_irradiance_over_pi(width_px, height_px, without_suns);
    environment.mips.push_back(packed(radiance, environment.scale));
    PictureLevel level{width_px, height_px, {}};
    std::span<const glm::vec3> texels = radiance;
    while (level.width_px > 1 || level.height_px > 1) {
        level = half_of(level.width_px, level.height_px, texels);
        texels = level.texels;
        environment.mips.push_back(packed(evened_towards_poles(level).texels, environment.scale));
    }
    environment.light = light_picture(width_px, height_px, without_suns);
    return environment;
}

float mean_luminance(const Environment& environment) {
    if (environment.mips.empty()) return 0;
    const glm::vec3 mean = glm::unpackF3x9_E1x5(environment.mips.back().front()) * environment.scale;
    return glm::dot(mean, glm::vec3(0.2126f, 0.7152f, 0.0722f));
}

std::array<float, 9> environment_basis(glm::vec3 d) {
    return {1, d.x, d.y, d.z, d.x * d.y, d.y * d.z, d.x * d.z, 3 * d.y * d.y - 1, d.x * d.x - d.z * d.z};
}

}  // namespace weft::scene
