#include "scene/pictures/picture_level.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/packing.hpp>
#include <numbers>

namespace weft::scene {
namespace {

// Largest value that glm stores in the shared-exponent format (E5B9G9R9).
constexpr float kMostStored = 32768;
// Largest factor by which stored texels are multiplied when they are read. kMostStored times this factor is
// more than the luminance of the sun's disc.
constexpr float kMostScale = 65536;

// For a picture that is made smaller along one axis: the range of source texels that one texel of the smaller
// picture covers along this axis. `begin` and `end` are the exact limits of the range as fractional
// positions, measured in source texels.
struct Cover {
    uint32_t first = 0;
    uint32_t last = 0;  // Index of the last source texel in the range, inclusive.
    double begin = 0;
    double end = 0;

    [[nodiscard]] double begin_of(uint32_t i) const { return std::max(begin, double(i)); }
    [[nodiscard]] double end_of(uint32_t i) const { return std::min(end, double(i) + 1); }
};

Cover cover(uint32_t index, uint32_t from, uint32_t to) {
    const double ratio = double(from) / double(to), begin = index * ratio, end = (index + 1) * ratio;
    return {static_cast<uint32_t>(begin), std::min(from, static_cast<uint32_t>(std::ceil(end))) - 1, begin,
            end};
}

}  // namespace

PictureLevel reduced(uint32_t width_px, uint32_t height_px, std::span<const glm::vec3> texels,
                     uint32_t to_width_px, uint32_t to_height_px) {
    PictureLevel level{to_width_px, to_height_px, {}};
    level.texels.resize(size_t{to_width_px} * to_height_px);
    for (uint32_t y = 0; y < to_height_px; ++y) {
        const Cover rows = cover(y, height_px, to_height_px);
        const auto height_at = [&](double row) { return std::cos(std::numbers::pi * row / height_px); };
        const double all = height_at(rows.begin) - height_at(rows.end);
        for (uint32_t x = 0; x < to_width_px; ++x) {
            const Cover columns = cover(x, width_px, to_width_px);
            glm::dvec3 sum(0);
            for (uint32_t row = rows.first; row <= rows.last; ++row) {
                glm::dvec3 line(0);
                for (uint32_t column = columns.first; column <= columns.last; ++column)
                    line += glm::dvec3(texels[size_t{row} * width_px + column]) *
                            (columns.end_of(column) - columns.begin_of(column));
                sum += line * (height_at(rows.begin_of(row)) - height_at(rows.end_of(row)));
            }
            level.texels[size_t{y} * to_width_px + x] =
                glm::vec3(sum / (all * (columns.end - columns.begin)));
        }
    }
    return level;
}

PictureLevel half_of(uint32_t width_px, uint32_t height_px, std::span<const glm::vec3> texels) {
    return reduced(width_px, height_px, texels, std::max(1u, width_px / 2), std::max(1u, height_px / 2));
}

PictureLevel evened_towards_poles(const PictureLevel& level) {
    PictureLevel even = level;
    const int64_t width = level.width_px;
    for (uint32_t y = 0; y < level.height_px; ++y) {
        const double sine = std::sin(std::numbers::pi * (y + 0.5) / level.height_px);
        const int64_t reach = std::min(width - 1, static_cast<int64_t>(std::llround(1 / sine)) - 1) / 2;
        if (reach == 0) continue;
        const auto at = [&](int64_t x) {
            return glm::dvec3(level.texels[size_t{y} * level.width_px + size_t((x + width) % width)]);
        };
        glm::dvec3 sum(0);
        for (int64_t x = -reach; x <= reach; ++x) sum += at(x);
        for (int64_t x = 0; x < width; ++x) {
            even.texels[size_t{y} * level.width_px + size_t(x)] = glm::vec3(sum / double(2 * reach + 1));
            sum += at(x + reach + 1) - at(x - reach);
        }
    }
    return even;
}

std::vector<uint32_t> packed(std::span<const glm::vec3> texels, float scale) {
    std::vector<uint32_t> words;
    words.reserve(texels.size());
    for (const glm::vec3& texel : texels)
        words.push_back(glm::packF3x9_E1x5(glm::min(texel / scale, glm::vec3(kMostStored))));
    return words;
}

float brightest(std::span<const glm::vec3> texels) {
    float most = 0;
    for (const glm::vec3& texel : texels) most = std::max({most, texel.r, texel.g, texel.b});
    return most;
}

float stored_scale(std::span<const glm::vec3> texels) {
    const float most = brightest(texels);
    float scale = 1;
    while (most > kMostStored * scale && scale < kMostScale) scale *= 2;
    return scale;
}

}  // namespace weft::scene
