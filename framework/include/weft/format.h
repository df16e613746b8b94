// Purpose: lists the formats of images and vertex attributes, with their names in graphs and their
// properties. Independent of Vulkan.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace weft {

enum class Format : uint8_t {
    undefined,
    r8,
    rg8,
    rgba8,
    rgba8_srgb,
    bgra8,
    bgra8_srgb,
    r8_snorm,
    rg8_snorm,
    rgba8_snorm,
    r8u,
    rg8u,
    rgba8u,
    r16,
    rg16,
    rgba16,
    rg16_snorm,
    rgba16_snorm,
    r16f,
    rg16f,
    rgba16f,
    r16u,
    rg16u,
    rgba16u,
    r32f,
    rg32f,
    rgba32f,
    r32u,
    rg32u,
    rgba32u,
    r32i,
    rg32i,
    rgba32i,
    rgb10a2,
    b10g11r11f,
    rgb9e5,
    d16,
    d32f,
    d32f_s8,
    d24_s8,
    s8,
    // Only for vertex attributes: most devices have no images with these formats, so graphs cannot name them.
    rgb32f,
    rgb32u,
    rgb32i,
};

// The type of the values that shaders read. float_like: the formats float, unorm, snorm and sRGB.
enum class NumericClass : uint8_t { float_like, sint, uint, depth };

struct FormatInfo {
    Format format = Format::undefined;
    std::string_view name;  // Name of the format in graphs, such as "rgba16f".
    uint8_t bytes_per_texel = 0;
    uint8_t components = 0;
    NumericClass numeric = NumericClass::float_like;
    bool srgb = false;
    bool depth = false;
    bool stencil = false;
    bool vertex_only = false;  // True: only vertex attributes can have this format.
};

[[nodiscard]] const FormatInfo& format_info(Format format);
// The two functions know only the formats that images can have.
[[nodiscard]] std::optional<Format> format_from_name(std::string_view name);
[[nodiscard]] std::vector<std::string> format_names();

}  // namespace weft
