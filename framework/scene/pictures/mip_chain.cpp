#include "scene/pictures/mip_chain.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/glm.hpp>

namespace weft::scene {
namespace {

// A mip level in the space in which texels are filtered: linear light for colours, [-1, 1] for normals.
struct MipLevel {
    uint32_t width_px = 0;
    uint32_t height_px = 0;
    std::vector<glm::vec4> texels;
};

// The source texels that one destination texel covers along one axis: one to three texels and their weights.
struct Taps {
    uint32_t first = 0;
    uint32_t count = 1;
    std::array<float, 3> weight{1, 0, 0};
};

Taps taps_for(uint32_t index, uint32_t source_px, uint32_t target_px) {
    if (source_px == target_px) return {index, 1, {1, 0, 0}};
    const double scale = static_cast<double>(source_px) / target_px;
    const double begin = index * scale;
    const double end = begin + scale;
    Taps taps;
    taps.first = static_cast<uint32_t>(begin);
    taps.count = std::min<uint32_t>(static_cast<uint32_t>(std::ceil(end - 1e-9)), source_px) - taps.first;
    assert(taps.count >= 1 && taps.count <= 3);
    for (uint32_t i = 0; i < taps.count; ++i) {
        const double low = std::max<double>(begin, taps.first + i);
        const double high = std::min<double>(end, taps.first + i + 1);
        taps.weight[i] = static_cast<float>((high - low) / scale);
    }
    return taps;
}

class Decoder {
 public:
    explicit Decoder(TexelMeaning meaning) {
        for (uint32_t i = 0; i < 256; ++i) {
            const float value = static_cast<float>(i) / 255.0f;
            alpha_[i] = value;
            color_[i] = meaning == TexelMeaning::srgb_color ? srgb_to_linear(value)
                        : meaning == TexelMeaning::normal   ? value * 2.0f - 1.0f
                                                            : value;
        }
    }
    [[nodiscard]] glm::vec4 decode(const uint8_t* texel) const {
        return {color_[texel[0]], color_[texel[1]], color_[texel[2]], alpha_[texel[3]]};
    }

 private:
    // Tables with one value for each byte: the value that the filters use. It is linear light for sRGB
    // colours, −1 to 1 for normals, and 0 to 1 for other data.
    std::array<float, 256> color_{}, alpha_{};
};

// Rounds to the nearest byte. Adding 0.5 is exact in double precision, so the result is the same as with
// std::lround(), which is slower.
uint8_t to_byte(float value) {
    return static_cast<uint8_t>(static_cast<double>(std::clamp(value, 0.0f, 1.0f) * 255.0f) + 0.5);
}

void encode(const glm::vec4& value, TexelMeaning meaning, float alpha_scale, uint8_t* texel) {
    glm::vec3 rgb(value);
    if (meaning == TexelMeaning::normal) {
        const float length = glm::length(rgb);
        rgb = (length > 1e-6f ? rgb / length : glm::vec3(0, 0, 1)) * 0.5f + 0.5f;
    }
    for (int c = 0; c < 3; ++c) {
        texel[c] = to_byte(meaning == TexelMeaning::srgb_color ? linear_to_srgb(rgb[c]) : rgb[c]);
    }
    texel[3] = to_byte(value.a * alpha_scale);
}

// Makes a mip level of half the size. `fetch(x, y)` returns a source texel in the form in which texels are
// filtered: linear light for colours, −1 to 1 for normals.
template <class Fetch>
MipLevel halve(uint32_t width_px, uint32_t height_px, const Fetch& fetch) {
    MipLevel out{std::max(1u, width_px / 2), std::max(1u, height_px / 2), {}};
    out.texels.resize(size_t{out.width_px} * out.height_px);
    std::vector<Taps> columns(out.width_px);
    for (uint32_t x = 0; x < out.width_px; ++x) columns[x] = taps_for(x, width_px, out.width_px);
    for (uint32_t y = 0; y < out.height_px; ++y) {
        const Taps rows = taps_for(y, height_px, out.height_px);
        for (uint32_t x = 0; x < out.width_px; ++x) {
            const Taps& column = columns[x];
            glm::vec4 sum(0);
            for (uint32_t j = 0; j < rows.count; ++j) {
                for (uint32_t i = 0; i < column.count; ++i) {
                    sum += fetch(column.first + i, rows.first + j) * (rows.weight[j] * column.weight[i]);
                }
            }
            out.texels[size_t{y} * out.width_px + x] = sum;
        }
    }
    return out;
}

double coverage(const MipLevel& level, float cutoff, float alpha_scale) {
    size_t passing = 0;
    for (const glm::vec4& texel : level.texels) passing += texel.a * alpha_scale >= cutoff;
    return static_cast<double>(passing) / static_cast<double>(level.texels.size());
}

double coverage(const std::vector<uint8_t>& rgba, float cutoff) {
    size_t passing = 0;
    for (size_t i = 3; i < rgba.size(); i += 4) passing += static_cast<float>(rgba[i]) / 255.0f >= cutoff;
    return static_cast<double>(passing) / (static_cast<double>(rgba.size()) / 4);
}

// Returns the factor for the alpha values of a mip level, at most 8. With this factor about the same share of
// texels passes the cutoff as in mip 0 (`wanted`).
float alpha_scale_for(const MipLevel& level, float cutoff, double wanted) {
    float low = 0;
    float high = 8;
    for (int i = 0; i < 12; ++i) {
        const float middle = (low + high) / 2;
        (coverage(level, cutoff, middle) < wanted ? low : high) = middle;
    }
    return high;
}

}  // namespace

float srgb_to_linear(float encoded) {
    return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

float linear_to_srgb(float linear) {
    return linear <= 0.0031308f ? linear * 12.92f : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

std::vector<std::vector<uint8_t>> build_mip_chain(uint32_t width_px, uint32_t height_px,
                                                  std::vector<uint8_t> rgba, const MipOptions& options) {
    assert(width_px > 0 && height_px > 0 && rgba.size() == size_t{width_px} * height_px * 4);
    std::vector<std::vector<uint8_t>> mips;
    mips.push_back(std::move(rgba));
    const bool keep_coverage = options.alpha_cutoff > 0;
    const double wanted = keep_coverage ? coverage(mips[0], options.alpha_cutoff) : 0;
    const Decoder decoder(options.meaning);
    MipLevel level{width_px, height_px, {}};
    while (level.width_px > 1 || level.height_px > 1) {
        if (mips.size() == 1) {
            // Mip 0 is decoded texel by texel and stays in bytes. As floats it would need four times as much
            // memory.
            level = halve(width_px, height_px, [&](uint32_t x, uint32_t y) {
                return decoder.decode(&mips[0][(size_t{y} * width_px + x) * 4]);
            });
        } else {
            level = halve(level.width_px, level.height_px, [&](uint32_t x, uint32_t y) {
                return level.texels[size_t{y} * level.width_px + x];
            });
        }
        const float scale = keep_coverage ? alpha_scale_for(level, options.alpha_cutoff, wanted) : 1.0f;
        std::vector<uint8_t> bytes(level.texels.size() * 4);
        for (size_t i = 0; i < level.texels.size(); ++i) {
            encode(level.texels[i], options.meaning, scale, &bytes[i * 4]);
        }
        mips.push_back(std::move(bytes));
    }
    return mips;
}

}  // namespace weft::scene
