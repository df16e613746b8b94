#include "weft/format.h"

#include <array>
#include <cassert>

namespace weft {
namespace {

using enum NumericClass;

// One row per format in the order of enum Format, so that the value of the enum is the index of its row.
constexpr std::array kFormats{
    FormatInfo{Format::undefined, "undefined", 0, 0, float_like},
    FormatInfo{Format::r8, "r8", 1, 1, float_like},
    FormatInfo{Format::rg8, "rg8", 2, 2, float_like},
    FormatInfo{Format::rgba8, "rgba8", 4, 4, float_like},
    FormatInfo{Format::rgba8_srgb, "rgba8_srgb", 4, 4, float_like, true},
    FormatInfo{Format::bgra8, "bgra8", 4, 4, float_like},
    FormatInfo{Format::bgra8_srgb, "bgra8_srgb", 4, 4, float_like, true},
    FormatInfo{Format::r8_snorm, "r8_snorm", 1, 1, float_like},
    FormatInfo{Format::rg8_snorm, "rg8_snorm", 2, 2, float_like},
    FormatInfo{Format::rgba8_snorm, "rgba8_snorm", 4, 4, float_like},
    FormatInfo{Format::r8u, "r8u", 1, 1, uint},
    FormatInfo{Format::rg8u, "rg8u", 2, 2, uint},
    FormatInfo{Format::rgba8u, "rgba8u", 4, 4, uint},
    FormatInfo{Format::r16, "r16", 2, 1, float_like},
    FormatInfo{Format::rg16, "rg16", 4, 2, float_like},
    FormatInfo{Format::rgba16, "rgba16", 8, 4, float_like},
    FormatInfo{Format::rg16_snorm, "rg16_snorm", 4, 2, float_like},
    FormatInfo{Format::rgba16_snorm, "rgba16_snorm", 8, 4, float_like},
    FormatInfo{Format::r16f, "r16f", 2, 1, float_like},
    FormatInfo{Format::rg16f, "rg16f", 4, 2, float_like},
    FormatInfo{Format::rgba16f, "rgba16f", 8, 4, float_like},
    FormatInfo{Format::r16u, "r16u", 2, 1, uint},
    FormatInfo{Format::rg16u, "rg16u", 4, 2, uint},
    FormatInfo{Format::rgba16u, "rgba16u", 8, 4, uint},
    FormatInfo{Format::r32f, "r32f", 4, 1, float_like},
    FormatInfo{Format::rg32f, "rg32f", 8, 2, float_like},
    FormatInfo{Format::rgba32f, "rgba32f", 16, 4, float_like},
    FormatInfo{Format::r32u, "r32u", 4, 1, uint},
    FormatInfo{Format::rg32u, "rg32u", 8, 2, uint},
    FormatInfo{Format::rgba32u, "rgba32u", 16, 4, uint},
    FormatInfo{Format::r32i, "r32i", 4, 1, sint},
    FormatInfo{Format::rg32i, "rg32i", 8, 2, sint},
    FormatInfo{Format::rgba32i, "rgba32i", 16, 4, sint},
    FormatInfo{Format::rgb10a2, "rgb10a2", 4, 4, float_like},
    FormatInfo{Format::b10g11r11f, "b10g11r11f", 4, 3, float_like},
    FormatInfo{Format::rgb9e5, "rgb9e5", 4, 3, float_like},
    FormatInfo{Format::d16, "d16", 2, 1, NumericClass::depth, false, true},
    FormatInfo{Format::d32f, "d32f", 4, 1, NumericClass::depth, false, true},
    FormatInfo{Format::d32f_s8, "d32f_s8", 8, 2, NumericClass::depth, false, true, true},
    FormatInfo{Format::d24_s8, "d24_s8", 4, 2, NumericClass::depth, false, true, true},
    FormatInfo{Format::s8, "s8", 1, 1, uint, false, false, true},
    FormatInfo{Format::rgb32f, "rgb32f", 12, 3, float_like, false, false, false, true},
    FormatInfo{Format::rgb32u, "rgb32u", 12, 3, uint, false, false, false, true},
    FormatInfo{Format::rgb32i, "rgb32i", 12, 3, sint, false, false, false, true},
};

constexpr bool in_order() {
    for (size_t i = 0; i < kFormats.size(); ++i) {
        if (static_cast<size_t>(kFormats[i].format) != i) return false;
    }
    return kFormats.size() == static_cast<size_t>(Format::rgb32i) + 1;
}
static_assert(in_order(), "one row for each Format, in its order");

bool is_of_images(const FormatInfo& info) {
    return info.format != Format::undefined && !info.vertex_only;
}

}  // namespace

const FormatInfo& format_info(Format format) {
    assert(static_cast<size_t>(format) < kFormats.size());
    return kFormats[static_cast<size_t>(format)];
}

std::optional<Format> format_from_name(std::string_view name) {
    for (const FormatInfo& info : kFormats) {
        if (info.name == name && is_of_images(info)) return info.format;
    }
    return std::nullopt;
}

std::vector<std::string> format_names() {
    std::vector<std::string> names;
    for (const FormatInfo& info : kFormats) {
        if (is_of_images(info)) names.emplace_back(info.name);
    }
    return names;
}

}  // namespace weft
