#include "scene/pictures/radiance_encode.h"

#include <algorithm>
#include <cmath>

namespace weft::scene {
namespace {

// The exponent that a byte with the value 0 would mean, plus the eight bits of a mantissa.
constexpr int kExponentBias = 128, kMantissaBits = 8;
constexpr float kDarkest = 1e-36f;  // Smaller values become 0.

void append_texel(const glm::vec3& texel, std::string& out) {
    const float largest = std::max({texel.r, texel.g, texel.b});
    if (largest < kDarkest) {
        out.append(4, '\0');
        return;
    }
    int exponent = 0;
    (void)std::frexp(largest, &exponent);
    // A mantissa that rounds to 256 does not fit into a byte.
    if (std::round(std::ldexp(largest, kMantissaBits - exponent)) > 255) ++exponent;
    for (int c = 0; c < 3; ++c)
        out.push_back(static_cast<char>(std::lround(std::ldexp(texel[c], kMantissaBits - exponent))));
    out.push_back(static_cast<char>(exponent + kExponentBias));
}

}  // namespace

std::string encode_radiance(uint32_t width_px, uint32_t height_px, std::span<const glm::vec3> texels) {
    std::string out = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(height_px) + " +X " +
                      std::to_string(width_px) + "\n";
    out.reserve(out.size() + texels.size() * 4);
    for (const glm::vec3& texel : texels) append_texel(texel, out);
    return out;
}

}  // namespace weft::scene
