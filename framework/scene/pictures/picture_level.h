// Purpose: mip levels of pictures in equirectangular projection. Row 0 is the direction +y (up). Filters
// weight each texel by the solid angle that it covers.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace weft::scene {

struct PictureLevel {
    uint32_t width_px = 0;
    uint32_t height_px = 0;
    std::vector<glm::vec3> texels;
};

// Makes a smaller picture. Each texel is the mean of the source texels that it covers.
[[nodiscard]] PictureLevel reduced(uint32_t width_px, uint32_t height_px, std::span<const glm::vec3> texels,
                                   uint32_t to_width_px, uint32_t to_height_px);
// Makes the next smaller mip level.
[[nodiscard]] PictureLevel half_of(uint32_t width_px, uint32_t height_px, std::span<const glm::vec3> texels);

// Smooths the rows near the poles. There the texels cover narrow areas, which would show as a star in blurred
// reflections. Each texel becomes the mean of itself and its neighbours in the row. Together these cover
// about the width of a texel at the equator.
[[nodiscard]] PictureLevel evened_towards_poles(const PictureLevel& level);

// Returns the largest channel of all texels.
[[nodiscard]] float brightest(std::span<const glm::vec3> texels);
// Returns the factor by which texels in the shared-exponent format (E5B9G9R9) must be multiplied when they
// are read. It is 1, or a larger power of two if a value exceeds the range of the format.
[[nodiscard]] float stored_scale(std::span<const glm::vec3> texels);
// Returns the texels divided by `scale`, in the shared-exponent format (E5B9G9R9).
[[nodiscard]] std::vector<uint32_t> packed(std::span<const glm::vec3> texels, float scale);

}  // namespace weft::scene
