// Purpose: references in double precision for the ambient light of surfaces: the directional albedo, and the
// light of an environment that a rough surface mirrors. They are sums over many directions, without the
// approximations of the shaders.
#pragma once

#include <functional>
#include <vector>

#include "tests/render/shading/reference_brdf.h"

namespace weft::test {

// Returns the directional albedo of GGX: the factor of F0 (x) and the factor of F90 (y). Half vectors are
// distributed as D · cos θ, so the weight of each is G2 · v·h / (n·v · n·h).
inline glm::dvec2 reference_albedo(double roughness, double n_v, int rings = 160, int sectors = 24) {
    const double alpha = std::max(roughness * roughness, 0.002);
    const glm::dvec3 v(std::sqrt(1 - n_v * n_v), 0, n_v);
    glm::dvec2 sum(0);
    double weights = 0;
    for (int i = 0; i < rings; ++i)
        for (int k = 0; k < sectors; ++k) {
            // The rings become narrower towards the rim.
            const double t = (i + 0.5) / rings, u = 1 - (1 - t) * (1 - t) * (1 - t),
                         width = (1 - t) * (1 - t);
            const double cos2 = (1 - u) / (1 + (alpha * alpha - 1) * u), cosine = std::sqrt(cos2),
                         sine = std::sqrt(1 - cos2), azimuth = kPi * (k + 0.5) / sectors;
            const glm::dvec3 h(sine * std::cos(azimuth), sine * std::sin(azimuth), cosine);
            const double v_h = glm::dot(v, h), n_l = 2 * v_h * h.z - n_v;
            weights += width;
            if (v_h <= 0 || n_l <= 0) continue;
            const double fresnel = std::pow(1 - v_h, 5);
            const double seen = smith_g2_correlated(alpha, n_l, n_v) * v_h / (n_v * cosine) * width;
            sum += seen * glm::dvec2(1 - fresnel, fresnel);
        }
    return sum / weights;
}

// A function from directions to radiance.
using Surroundings = std::function<double(const glm::dvec3&)>;

// The texels of a cube map, as directions, solid angles and mean radiances.
struct CubeSum {
    static constexpr int kSide = 64;
    std::vector<glm::dvec3> directions;
    std::vector<double> angles;
    std::vector<double> radiance;
};

inline CubeSum cube_sum(const Surroundings& light) {
    CubeSum cube;
    const int n = CubeSum::kSide;
    const auto corner = [](double x, double y) { return std::atan2(x * y, std::sqrt(x * x + y * y + 1)); };
    for (int face = 0; face < 6; ++face)
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x) {
                const auto at = [&](double u, double v) {
                    const double side = face % 2 == 0 ? 1 : -1;
                    glm::dvec3 d;
                    d[face / 2] = side;
                    d[(face / 2 + 1) % 3] = u;
                    d[(face / 2 + 2) % 3] = v;
                    return glm::normalize(d);
                };
                const double u = 2.0 * x / n - 1, v = 2.0 * y / n - 1, step = 2.0 / n;
                double sum = 0;
                for (int i = 0; i < 16; ++i)
                    sum += light(at(u + step * (i % 4 + 0.5) / 4, v + step * (i / 4 + 0.5) / 4)) / 16;
                cube.directions.push_back(at(u + step / 2, v + step / 2));
                cube.angles.push_back(corner(u + step, v + step) - corner(u, v + step) - corner(u + step, v) +
                                      corner(u, v));
                cube.radiance.push_back(sum);
            }
    return cube;
}

// Returns the light that a surface with the normal n mirrors if it is seen from straight above (N = V = R).
// The lobe must be wider than a texel of the cube: a roughness of 0.2 or more.
inline double filtered(const CubeSum& cube, const glm::dvec3& n, double roughness) {
    const double a2 = std::pow(roughness, 4);
    double sum = 0, weights = 0;
    for (size_t i = 0; i < cube.directions.size(); ++i) {
        const double n_l = glm::dot(n, cube.directions[i]);
        if (n_l <= 0) continue;
        const double q = (a2 - 1) * (1 + n_l) / 2 + 1, weight = n_l * cube.angles[i] / (q * q);
        sum += weight * cube.radiance[i];
        weights += weight;
    }
    return sum / weights;
}

// The same for any roughness, as a mean over many half vectors that are distributed as D · cos θ.
inline double sampled(const Surroundings& light, const glm::dvec3& n, double roughness, int steps = 40) {
    const double a2 = std::pow(roughness, 4);
    const glm::dvec3 x =
        glm::normalize(glm::cross(n, std::abs(n.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0)));
    const glm::dvec3 y = glm::cross(n, x);
    double sum = 0, weights = 0;
    for (int i = 0; i < steps * steps; ++i) {
        const double u = (i / steps + 0.5) / steps, azimuth = 2 * kPi * (i % steps + 0.5) / steps;
        const double cos2 = (1 - u) / (1 + (a2 - 1) * u), cosine = 2 * cos2 - 1;
        if (cosine <= 0) continue;
        const double sine = std::sqrt(1 - cosine * cosine);
        sum += cosine * light(sine * (std::cos(azimuth) * x + std::sin(azimuth) * y) + cosine * n);
        weights += cosine;
    }
    return sum / weights;
}

}  // namespace weft::test
