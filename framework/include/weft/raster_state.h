// Purpose: the state of the fixed-function pipeline of a pass that draws: depth and stencil tests, blending,
// culling and so on. The names follow Vulkan.
#pragma once

#include <cstdint>
#include <optional>

namespace weft {

enum class CompareOp : uint8_t { never, less, equal, less_equal, greater, not_equal, greater_equal, always };
enum class CullMode : uint8_t { none, front, back, material };
enum class FrontFace : uint8_t { counter_clockwise, clockwise };
enum class Topology : uint8_t { triangles, triangle_strip, lines, line_strip, points };
enum class FillMode : uint8_t { fill, line, point };
enum class BlendFactor : uint8_t {
    zero,
    one,
    src_color,
    one_minus_src_color,
    dst_color,
    one_minus_dst_color,
    src_alpha,
    one_minus_src_alpha,
    dst_alpha,
    one_minus_dst_alpha,
};
enum class BlendOp : uint8_t { add, subtract, reverse_subtract, min, max };
enum class StencilOp : uint8_t {
    keep,
    zero,
    replace,
    increment_clamp,
    decrement_clamp,
    invert,
    increment_wrap,
    decrement_wrap,
};

struct BlendState {
    bool enabled = false;
    BlendFactor src_color = BlendFactor::one, dst_color = BlendFactor::zero;
    BlendOp color_op = BlendOp::add;
    BlendFactor src_alpha = BlendFactor::one, dst_alpha = BlendFactor::zero;
    BlendOp alpha_op = BlendOp::add;
    uint8_t write_mask = 0xF;  // Sum of the channels to write: r 1, g 2, b 4, a 8.
    bool operator==(const BlendState&) const = default;
};

struct StencilFaceState {
    CompareOp compare = CompareOp::always;
    StencilOp fail = StencilOp::keep, depth_fail = StencilOp::keep, pass = StencilOp::keep;
    uint8_t read_mask = 0xFF, write_mask = 0xFF, reference = 0;
    bool operator==(const StencilFaceState&) const = default;
};

struct RectPx {
    int32_t x = 0, y = 0;
    uint32_t width = 0, height = 0;
    bool operator==(const RectPx&) const = default;
};

// The state of the fixed-function pipeline of one pass. Source: P. Cozzi, "The Graphics Pipeline".
struct RasterState {
    Topology topology = Topology::triangles;
    FillMode fill = FillMode::fill;
    CullMode cull = CullMode::none;
    FrontFace front_face = FrontFace::counter_clockwise;
    bool depth_test = false;
    bool depth_write = false;
    CompareOp depth_compare = CompareOp::greater;
    bool depth_clamp = false;
    float depth_bias_constant = 0, depth_bias_slope = 0, depth_bias_clamp = 0;
    bool stencil_test = false;
    StencilFaceState stencil_front, stencil_back;
    bool alpha_to_coverage = false;
    std::optional<RectPx> scissor;  // Scissor rectangle in pixels; absent: the whole attachment.
    std::optional<RectPx> viewport;
    bool operator==(const RasterState&) const = default;
};

}  // namespace weft
