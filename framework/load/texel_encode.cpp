#include "load/texel_encode.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>
#include <limits>

#include "scene/pictures/mip_chain.h"

namespace weft {
namespace {

template <class T>
void put(T value, std::vector<std::byte>& out) {
    const auto bytes = std::as_bytes(std::span(&value, 1));
    out.insert(out.end(), bytes.begin(), bytes.end());
}

// Rounds and clamps to the range of T. NaN becomes 0.
template <class T>
void put_whole(double value, std::vector<std::byte>& out) {
    const double least = std::numeric_limits<T>::min(), most = std::numeric_limits<T>::max();
    put(static_cast<T>(std::isnan(value) ? 0 : std::clamp(std::round(value), least, most)), out);
}

template <class T>
void put_unorm(float value, std::vector<std::byte>& out) {
    put_whole<T>(double{value} * std::numeric_limits<T>::max(), out);
}

template <class T>
void put_snorm(float value, std::vector<std::byte>& out) {
    const double most = std::numeric_limits<T>::max();
    put_whole<T>(std::max(double{value} * most, -most), out);
}

void put_channel(const FormatInfo& info, float value, float whole, std::vector<std::byte>& out) {
    const std::string_view name = info.name;
    const uint32_t bytes = info.bytes_per_texel / info.components;
    const double number = whole > 0 ? double{value} * whole : double{value};
    if (info.numeric == NumericClass::sint) return put_whole<int32_t>(number, out);
    if (info.numeric == NumericClass::uint) {
        if (bytes == 1) return put_whole<uint8_t>(number, out);
        return bytes == 2 ? put_whole<uint16_t>(number, out) : put_whole<uint32_t>(number, out);
    }
    if (name.ends_with("32f")) return put(value, out);
    if (name.ends_with("16f")) return put(glm::packHalf1x16(value), out);
    if (name.ends_with("snorm"))
        return bytes == 1 ? put_snorm<int8_t>(value, out) : put_snorm<int16_t>(value, out);
    return bytes == 1 ? put_unorm<uint8_t>(value, out) : put_unorm<uint16_t>(value, out);
}

// Converts a colour to one of the formats that pack all channels into one word. Returns false for other
// formats.
bool put_packed(Format format, const glm::vec4& value, std::vector<std::byte>& out) {
    if (format == Format::rgb10a2) put(glm::packUnorm3x10_1x2(value), out);
    if (format == Format::b10g11r11f) put(glm::packF2x11_1x10(glm::vec3(value)), out);
    if (format == Format::rgb9e5) put(glm::packF3x9_E1x5(glm::vec3(value)), out);
    return format == Format::rgb10a2 || format == Format::b10g11r11f || format == Format::rgb9e5;
}

}  // namespace

std::vector<std::byte> encode_texels(Format format, std::span<const glm::vec4> values,
                                     const TexelSource& source) {
    const FormatInfo& info = format_info(format);
    std::vector<std::byte> out;
    out.reserve(values.size() * info.bytes_per_texel);
    for (glm::vec4 value : values) {
        if (info.srgb && !source.is_encoded)
            for (int c = 0; c < 3; ++c) value[c] = scene::linear_to_srgb(value[c]);
        if (put_packed(format, value, out)) continue;
        if (info.name.starts_with("bgra")) std::swap(value.r, value.b);
        for (int c = 0; c < info.components; ++c) put_channel(info, value[c], source.whole, out);
    }
    return out;
}

std::vector<glm::vec4> halve(std::span<const glm::vec4> values, uint32_t width, uint32_t height) {
    const uint32_t new_width = std::max(1u, width / 2), new_height = std::max(1u, height / 2);
    const double step_x = double{1} * width / new_width, step_y = double{1} * height / new_height;
    std::vector<glm::vec4> out;
    out.reserve(size_t{new_width} * new_height);
    // Returns the part of texel `at` that lies between `begin` and `end`.
    const auto share = [](uint32_t at, double begin, double end) {
        return std::max(0.0, std::min(end, at + 1.0) - std::max(begin, double{1} * at));
    };
    for (uint32_t y = 0; y < new_height; ++y) {
        for (uint32_t x = 0; x < new_width; ++x) {
            const double left = x * step_x, right = left + step_x, top = y * step_y, bottom = top + step_y;
            glm::dvec4 sum(0);
            for (auto v = static_cast<uint32_t>(top); v < height && v < bottom; ++v)
                for (auto u = static_cast<uint32_t>(left); u < width && u < right; ++u)
                    sum += glm::dvec4(values[size_t{v} * width + u]) * share(u, left, right) *
                           share(v, top, bottom);
            out.emplace_back(sum / (step_x * step_y));
        }
    }
    return out;
}

}  // namespace weft
