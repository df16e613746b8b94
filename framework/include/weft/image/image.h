// Purpose: a picture, and a plane with one number per texel, as plain data for image metrics. Shapes:
// width_px × height_px, row 0 at the top. Units: `display` values are sRGB-encoded, in [0, 1]. `linear`
// values are scene-linear, in any unit; they must not be NaN when they are converted to display values.
// Source: sRGB: IEC 61966-2-1.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace weft::image {

enum class Encoding : uint8_t { display, linear };

struct Image {
    uint32_t width_px = 0;
    uint32_t height_px = 0;
    Encoding encoding = Encoding::display;
    std::vector<glm::vec3> texels;
};

struct Plane {
    uint32_t width_px = 0;
    uint32_t height_px = 0;
    std::vector<float> values;
};

[[nodiscard]] bool same_size(const Image& a, const Image& b);

// Returns the picture as display values. Linear values are clamped to [0, 1] and encoded without rounding.
// Display values do not change.
[[nodiscard]] Image to_display(Image image);
[[nodiscard]] glm::vec3 display_texel(const Image& image, size_t index);

[[nodiscard]] float encode_srgb(float linear);
[[nodiscard]] float decode_srgb(float encoded);

}  // namespace weft::image
