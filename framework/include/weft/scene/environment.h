// Purpose: a picture of a scene's surroundings in equirectangular projection, prepared for display and
// lighting: a mip chain whose texels are averages over solid angles, and the irradiance for each direction.
// Units: cd/m². Orientation: row 0 is the direction +y (up). The middle column is the direction −z, in which
// an unrotated camera looks; +x is to the right of it. Source: R. Ramamoorthi, P. Hanrahan, "An Efficient
// Representation for Irradiance Environment Maps", 2001.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

namespace weft::scene {

// A small version of a picture of the surroundings, from which the light on surfaces is computed. The format
// of `mips` and `scale` is that of Environment.
struct LightPicture {
    uint32_t width_px = 0;
    uint32_t height_px = 0;
    std::vector<std::vector<uint32_t>> mips;
    float scale = 1;
    float brightest = 0;  // The largest channel of all texels of mip 0, in cd/m².
};

// A sun that was found in a picture of the surroundings: a small region of very bright texels.
struct PictureSun {
    glm::vec3 to_sun{0, 1, 0};  // Unit vector to the centroid of the light.
    float solid_angle_sr = 0;   // Solid angle of the region.
    // Angular radius of a disc of uniform luminance whose light spreads as widely as the light of the region.
    float angular_radius_rad = 0;
    // The illuminance that the region adds on a plane that faces it, in lx, Rec.709.
    glm::vec3 illuminance_lx{0};
};

// A picture of the surroundings of a scene. If `mips` is empty, the scene has none.
struct Environment {
    std::string name;
    uint32_t width_px = 0;
    uint32_t height_px = 0;
    // The texels of every mip, mip 0 first, to the end of the chain. A texel is one word with three mantissas
    // and a shared exponent (glm::unpackF3x9_E1x5, Vulkan's E5B9G9R9).
    std::vector<std::vector<uint32_t>> mips;
    // Multiply every texel by this factor. It is 1, or a larger power of two if a value exceeds the range of
    // the format.
    float scale = 1;
    // The light as spherical harmonics of the orders 0, 1 and 2: the irradiance / π on a plane with normal n
    // is the sum of irradiance_over_pi[i] × environment_basis(n)[i]. A small bright source, such as the sun,
    // can cause negative values for directions away from it (ringing). Then the orders 1 and 2 are reduced.
    std::array<glm::vec3, 9> irradiance_over_pi{};
    LightPicture light;
    // The suns of the picture, the brightest first. `mips` shows them, but irradiance_over_pi does not
    // contain their light, because the scene has a directional light for each of them.
    std::vector<PictureSun> suns;
};

// Makes an Environment from radiance in cd/m²: width_px × height_px texels, all finite and not negative.
[[nodiscard]] Environment build_environment(uint32_t width_px, uint32_t height_px,
                                            std::span<const glm::vec3> radiance);
// Makes an Environment from a picture with suns. `radiance` has the texels of the picture, and `without_suns`
// has the same texels without the suns. The light of the environment is computed from `without_suns`.
[[nodiscard]] Environment build_environment(uint32_t width_px, uint32_t height_px,
                                            std::span<const glm::vec3> radiance,
                                            std::span<const glm::vec3> without_suns);

// Returns the mean Rec.709 luminance over the whole sphere in cd/m²; 0 if there is no environment.
[[nodiscard]] float mean_luminance(const Environment& environment);

// Returns the basis functions of irradiance_over_pi: 1, x, y, z, xy, yz, xz, 3y² − 1, x² − z².
[[nodiscard]] std::array<float, 9> environment_basis(glm::vec3 direction);

}  // namespace weft::scene
