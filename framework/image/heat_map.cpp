#include "weft/image/heat_map.h"

#include <algorithm>
#include <cmath>

namespace weft::image {
namespace {

constexpr std::array<uint32_t, 10> kMagma{0x000004, 0x180f3e, 0x451077, 0x721f81, 0x9f2f7f,
                                          0xcd4071, 0xf1605d, 0xfd9567, 0xfec98d, 0xfcfdbf};

}  // namespace

std::array<std::byte, 4> magma(float error) {
    const float inside = std::isnan(error) ? 1 : std::clamp(error, 0.0f, 1.0f);
    const float at = inside * (kMagma.size() - 1);
    const size_t low = std::min(static_cast<size_t>(at), kMagma.size() - 2);
    const float share = at - static_cast<float>(low);
    std::array<std::byte, 4> color{std::byte{0}, std::byte{0}, std::byte{0}, std::byte{255}};
    for (size_t c = 0; c < 3; ++c) {
        const auto channel = [&](uint32_t rgb) { return static_cast<float>(rgb >> (16 - 8 * c) & 0xff); };
        const float value = std::lerp(channel(kMagma[low]), channel(kMagma[low + 1]), share);
        color[c] = static_cast<std::byte>(std::lround(value));
    }
    return color;
}

std::vector<std::byte> heat_map(const Plane& map) {
    std::vector<std::byte> rgba;
    rgba.reserve(map.values.size() * 4);
    for (const float error : map.values) {
        const std::array<std::byte, 4> color = magma(error);
        rgba.insert(rgba.end(), color.begin(), color.end());
    }
    return rgba;
}

}  // namespace weft::image
