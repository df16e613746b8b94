// Purpose: an equirectangular picture of what surrounds a scene, made ready to be looked at and to light:
// a mip chain whose texels are means over solid angles, and the irradiance it sends to each direction.
// Units: cd/m². Orientation: row 0 is around +y; the middle column is towards −z, where a camera that is not
// turned looks, and +x lies right of it.
// Source: R. Ramamoorthi, P. Hanrahan, "An Efficient Representation for Irradiance Environment Maps", 2001.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

namespace weft::scene {

// Nothing is there while `mips` is empty.
struct Environment {
    std::string name;
    uint32_t width_px = 0;
    uint32_t height_px = 0;
    // Words of three mantissas and a shared exponent (glm::unpackF3x9_E1x5, Vulkan's E5B9G9R9), the full
    // chain.
    std::vector<std::vector<uint32_t>> mips;
    float scale = 1;  // of every texel: a power of two, more than 1 where something outshines the format
    // Irradiance / π on a plane with normal n is the sum of these times environment_basis(n); exact for light
    // of three orders, dampened where a small bright source would make them ring.
    std::array<glm::vec3, 9> irradiance_over_pi{};
};

// `radiance`: width_px × height_px texels, finite and not negative.
[[nodiscard]] Environment build_environment(uint32_t width_px, uint32_t height_px,
                                            std::span<const glm::vec3> radiance);

// Rec.709 luminance, cd/m², over the whole sphere; 0 without an environment.
[[nodiscard]] float mean_luminance(const Environment& environment);

// 1, x, y, z, xy, yz, xz, 3y² − 1, x² − z².
[[nodiscard]] std::array<float, 9> environment_basis(glm::vec3 direction);

}  // namespace weft::scene
