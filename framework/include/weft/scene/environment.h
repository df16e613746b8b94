// Purpose: an equirectangular picture of a scene's surroundings, prepared for display and lighting: a mip
// chain whose texels are means over solid angles, and the irradiance for each direction. Units: cd/m².
// Orientation: row 0 is around +y; the middle column is towards −z, the direction of an unrotated camera, and
// +x lies to its right. Source: R. Ramamoorthi, P. Hanrahan, "An Efficient Representation for Irradiance
// Environment Maps", 2001.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

namespace weft::scene {

// If `mips` is empty, there is no environment.
struct Environment {
    std::string name;
    uint32_t width_px = 0;
    uint32_t height_px = 0;
    // Each word has three mantissas and a shared exponent (glm::unpackF3x9_E1x5, Vulkan's E5B9G9R9); the full
    // mip chain.
    std::vector<std::vector<uint32_t>> mips;
    float scale = 1;  // factor for every texel: a power of two, above 1 if a value exceeds the format's range
    // Irradiance / π on a plane with normal n is the sum of these times environment_basis(n). Exact for light
    // of three orders; higher orders are reduced where a small bright source would cause ringing.
    std::array<glm::vec3, 9> irradiance_over_pi{};
};

// `radiance`: width_px × height_px texels, finite and not negative.
[[nodiscard]] Environment build_environment(uint32_t width_px, uint32_t height_px,
                                            std::span<const glm::vec3> radiance);

// Mean Rec.709 luminance over the whole sphere, in cd/m²; 0 without an environment.
[[nodiscard]] float mean_luminance(const Environment& environment);

// 1, x, y, z, xy, yz, xz, 3y² − 1, x² − z².
[[nodiscard]] std::array<float, 9> environment_basis(glm::vec3 direction);

}  // namespace weft::scene
