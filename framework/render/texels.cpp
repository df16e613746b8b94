#include "weft/render/texels.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <glm/gtc/packing.hpp>
#include <string_view>

#include "scene/pictures/mip_chain.h"

namespace weft::render {
namespace {

template <class T>
T load(const std::byte* bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof value);
    return value;
}

// How one channel of a texel is stored. `whole` is an integer, `half` and `single` are floats of 16 and 32
// bits. Formats that pack several channels into one word are decoded by packed_texel() instead.
enum class Channel : uint8_t { unorm, snorm, whole, half, single };

template <class Unsigned, class Signed>
float integer_channel(const std::byte* at, Channel channel, bool is_signed) {
    if (channel == Channel::snorm) {
        const float most = static_cast<float>((1u << (8 * sizeof(Unsigned) - 1)) - 1);
        return std::max(-1.0f, static_cast<float>(load<Signed>(at)) / most);
    }
    if (channel == Channel::whole)
        return is_signed ? static_cast<float>(load<Signed>(at)) : static_cast<float>(load<Unsigned>(at));
    const float most = static_cast<float>((uint64_t{1} << (8 * sizeof(Unsigned))) - 1);
    return static_cast<float>(load<Unsigned>(at)) / most;
}

float channel_value(const std::byte* at, uint32_t bytes, Channel channel, bool is_signed) {
    if (channel == Channel::half) return glm::unpackHalf1x16(load<uint16_t>(at));
    if (channel == Channel::single) return load<float>(at);
    if (bytes == 1) return integer_channel<uint8_t, int8_t>(at, channel, is_signed);
    if (bytes == 2) return integer_channel<uint16_t, int16_t>(at, channel, is_signed);
    return is_signed ? static_cast<float>(load<int32_t>(at)) : static_cast<float>(load<uint32_t>(at));
}

Channel channel_of(const FormatInfo& info) {
    const std::string_view name = info.name;
    if (info.numeric == NumericClass::uint || info.numeric == NumericClass::sint) return Channel::whole;
    if (name.ends_with("snorm")) return Channel::snorm;
    if (name.ends_with("32f") || name == "d32f_s8") return Channel::single;
    return name.ends_with("16f") ? Channel::half : Channel::unorm;
}

// Decodes a float without a sign bit: 5 bits of exponent and `mantissa_bits` bits of mantissa, as in
// b10g11r11f.
float small_float(uint32_t bits, uint32_t mantissa_bits) {
    const uint32_t exponent = bits >> mantissa_bits;
    const float mantissa =
        static_cast<float>(bits & ((1u << mantissa_bits) - 1)) / static_cast<float>(1u << mantissa_bits);
    if (exponent == 31) return mantissa > 0 ? NAN : INFINITY;
    if (exponent == 0) return std::ldexp(mantissa, -14);
    return std::ldexp(1 + mantissa, static_cast<int>(exponent) - 15);
}

glm::vec4 packed_texel(Format format, uint32_t word) {
    switch (format) {
        case Format::rgb10a2:
            return glm::unpackUnorm3x10_1x2(word);
        case Format::b10g11r11f:
            return {small_float(word & 0x7FF, 6), small_float((word >> 11) & 0x7FF, 6),
                    small_float(word >> 22, 5), 1};
        case Format::rgb9e5:
            return {glm::unpackF3x9_E1x5(word), 1};
        default:
            // The format is d24_s8: 24 bits of depth as unorm; the stencil bits are ignored.
            return {static_cast<float>(word & 0xFFFFFF) / 16777215.0f, 0, 0, 1};
    }
}

bool is_packed(Format format) {
    return format == Format::rgb10a2 || format == Format::b10g11r11f || format == Format::rgb9e5 ||
           format == Format::d24_s8;
}

glm::vec4 plain_texel(const FormatInfo& info, const std::byte* at) {
    const uint32_t channels = info.depth ? 1 : info.components;
    const uint32_t bytes = info.format == Format::d32f_s8 ? 4 : info.bytes_per_texel / channels;
    glm::vec4 texel(0, 0, 0, 1);
    for (uint32_t c = 0; c < channels; ++c)
        texel[static_cast<int>(c)] =
            channel_value(at + c * bytes, bytes, channel_of(info), info.numeric == NumericClass::sint);
    if (info.name.starts_with("bgra")) std::swap(texel.r, texel.b);
    if (info.srgb)
        for (int c = 0; c < 3; ++c) texel[c] = scene::srgb_to_linear(texel[c]);
    return texel;
}

}  // namespace

std::vector<glm::vec4> decode_texels(Format format, std::span<const std::byte> bytes) {
    const FormatInfo& info = format_info(format);
    const size_t stride = info.bytes_per_texel;
    std::vector<glm::vec4> texels;
    texels.reserve(bytes.size() / stride);
    for (size_t offset = 0; offset + stride <= bytes.size(); offset += stride) {
        const std::byte* at = bytes.data() + offset;
        texels.push_back(is_packed(format) ? packed_texel(format, load<uint32_t>(at))
                                           : plain_texel(info, at));
    }
    return texels;
}

}  // namespace weft::render
