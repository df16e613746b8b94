#include "scene/pictures/light_pictures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "scene/model/light_check.h"
#include "scene/pictures/mip_chain.h"

namespace weft::scene {
namespace {

constexpr uint32_t kSize = kLightPictureSize_px;

// Returns the index of the smallest mip level whose width and height are at least kSize; 0 if all levels are
// smaller.
uint32_t source_mip(const Texture& texture) {
    uint32_t mip = 0;
    while (mip + 1 < texture.mips.size() &&
           std::min(texture.width_px >> (mip + 1), texture.height_px >> (mip + 1)) >= kSize)
        ++mip;
    return mip;
}

// Returns the colour at (u, v) as sRGB bytes: a bilinear interpolation of four texels in linear light.
std::array<uint8_t, 4> sampled(const Texture& texture, uint32_t mip, float u, float v) {
    const int width = static_cast<int>(std::max(1u, texture.width_px >> mip)),
              height = static_cast<int>(std::max(1u, texture.height_px >> mip));
    const std::vector<uint8_t>& texels = texture.mips[mip];
    const float x = u * static_cast<float>(width) - 0.5f, y = v * static_cast<float>(height) - 0.5f;
    const float left = std::floor(x), top = std::floor(y);
    std::array<uint8_t, 4> out{0, 0, 0, 255};
    for (int channel = 0; channel < 3; ++channel) {
        float sum = 0;
        for (int corner = 0; corner < 4; ++corner) {
            const int column = std::clamp(static_cast<int>(left) + (corner & 1), 0, width - 1);
            const int row = std::clamp(static_cast<int>(top) + (corner >> 1), 0, height - 1);
            const float share =
                ((corner & 1) ? x - left : 1 - (x - left)) * ((corner >> 1) ? y - top : 1 - (y - top));
            const uint8_t stored = texels[static_cast<size_t>((row * width + column) * 4 + channel)];
            const float value = static_cast<float>(stored) / 255;
            sum += share * (texture.color_space == ColorSpace::srgb ? srgb_to_linear(value) : value);
        }
        out[static_cast<size_t>(channel)] = static_cast<uint8_t>(std::lround(255 * linear_to_srgb(sum)));
    }
    return out;
}

std::vector<std::vector<uint8_t>> resampled(const Texture& texture) {
    const uint32_t mip = source_mip(texture);
    std::vector<uint8_t> rgba;
    rgba.reserve(size_t{kSize} * kSize * 4);
    for (uint32_t y = 0; y < kSize; ++y) {
        for (uint32_t x = 0; x < kSize; ++x) {
            const std::array<uint8_t, 4> texel = sampled(texture, mip, (static_cast<float>(x) + 0.5f) / kSize,
                                                         (static_cast<float>(y) + 0.5f) / kSize);
            rgba.insert(rgba.end(), texel.begin(), texel.end());
        }
    }
    return build_mip_chain(kSize, kSize, std::move(rgba), {TexelMeaning::srgb_color, -1});
}

}  // namespace

LightPictures light_pictures(const Scene& scene) {
    LightPictures pictures;
    std::map<uint32_t, uint32_t> layer_of_texture;
    for (const LightFunction& function : scene.light_functions) {
        pictures.layer_of.push_back(kNone);
        if (function.picture == kNone) continue;
        const auto found = layer_of_texture.find(function.picture);
        if (found != layer_of_texture.end()) {
            pictures.layer_of.back() = found->second;
            continue;
        }
        if (function.picture >= scene.textures.size() || scene.textures[function.picture].mips.empty() ||
            pictures.layers == kMaxLightPictures)
            continue;
        const std::vector<std::vector<uint8_t>> mips = resampled(scene.textures[function.picture]);
        pictures.mips.resize(mips.size());
        for (size_t mip = 0; mip < mips.size(); ++mip)
            pictures.mips[mip].insert(pictures.mips[mip].end(), mips[mip].begin(), mips[mip].end());
        layer_of_texture.emplace(function.picture, pictures.layers);
        pictures.layer_of.back() = pictures.layers++;
    }
    return pictures;
}

}  // namespace weft::scene
