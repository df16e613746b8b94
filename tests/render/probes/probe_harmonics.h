// Purpose: spherical harmonics of the light that a probe sees, computed on the CPU in double precision. The
// basis is orthonormal and the solid angles of texels are exact, so this shares no formula with the shaders.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <numbers>

namespace weft::test {

// Coefficients of radiance for the orders 0, 1 and 2.
using Harmonics = std::array<double, 9>;

inline Harmonics orthonormal_basis(const glm::dvec3& n) {
    return {0.28209479177387814,
            0.4886025119029199 * n.y,
            0.4886025119029199 * n.z,
            0.4886025119029199 * n.x,
            1.0925484305920792 * n.x * n.y,
            1.0925484305920792 * n.y * n.z,
            0.31539156525252005 * (3 * n.z * n.z - 1),
            1.0925484305920792 * n.x * n.z,
            0.5462742152960396 * (n.x * n.x - n.y * n.y)};
}

// Returns the irradiance of a surface with the normal `n`.
inline double irradiance_of(const Harmonics& radiance, const glm::dvec3& n) {
    constexpr double kPi = std::numbers::pi;
    constexpr std::array<double, 3> kCosineLobe{kPi, 2 * kPi / 3, kPi / 4};
    const Harmonics basis = orthonormal_basis(n);
    double sum = 0;
    for (size_t i = 0; i < basis.size(); ++i)
        sum += kCosineLobe[i == 0 ? 0 : (i < 4 ? 1 : 2)] * radiance[i] * basis[i];
    return sum;
}

// Returns the direction of a point of a face of a cube map: +x, -x, +y, -y, +z, -z. u and v are from -1 to 1.
inline glm::dvec3 cube_direction(int face, double u, double v) {
    switch (face) {
        case 0:
            return {1, -v, -u};
        case 1:
            return {-1, -v, u};
        case 2:
            return {u, 1, v};
        case 3:
            return {u, -1, -v};
        case 4:
            return {u, -v, 1};
        default:
            return {-u, -v, -1};
    }
}

// Multiplies radiance(direction) by the basis functions, and adds up the texels of a cube with size² texels
// per face.
template <class Radiance>
Harmonics project(uint32_t size, const Radiance& radiance) {
    Harmonics sum{};
    const auto corner = [](double u, double v) { return std::atan2(u * v, std::sqrt(u * u + v * v + 1)); };
    for (int face = 0; face < 6; ++face)
        for (uint32_t y = 0; y < size; ++y)
            for (uint32_t x = 0; x < size; ++x) {
                const double step = 2.0 / size, u = x * step - 1, v = y * step - 1;
                const double angle =
                    corner(u, v) - corner(u, v + step) - corner(u + step, v) + corner(u + step, v + step);
                const glm::dvec3 direction = glm::normalize(cube_direction(face, u + step / 2, v + step / 2));
                const double light = radiance(direction) * angle;
                const Harmonics basis = orthonormal_basis(direction);
                for (size_t i = 0; i < sum.size(); ++i) sum[i] += light * basis[i];
            }
    return sum;
}

}  // namespace weft::test
