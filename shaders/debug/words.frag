// Debug view of a buffer: shows each 32-bit word as an unsigned integer, row by row from the top left. Output:
// sRGB-encoded colours in [0, 1]. DECODE selects how values become colours: it is an index into debug_decoders()
// in C++.
#version 460
#include "debug_colors.glsl"
#include "debug_digits.glsl"
#include "debug_legend.glsl"

layout(constant_id = 0) const uint DECODE = 11;

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;

readonly buffer Shown { uint items[]; } shown;

layout(push_constant) uniform Params {
    float black, white;  // The values that are shown as black and as white.
    vec2 size_px;        // The size of the debug view.
} params;

void main() {
    const uint count = shown.items.length();
    const uint side = uint(ceil(sqrt(float(count))));
    const uvec2 at = uvec2(uv * float(side));
    const uint i = at.y * side + at.x;
    if (i >= count) {
        color = vec4(0.1, 0.1, 0.1, 1.0);  // Dark grey: this pixel is after the end of the buffer.
        return;
    }
    const float y = (float(shown.items[i]) - params.black) / (params.white - params.black);
    const vec3 picked = DECODE == 12 ? index_color(uint(shown.items[i])) : DECODE == 11 ? heat_color(y) : vec3(y);
    // Choose the legend. Decoder 12 ("index") shows index colours, decoder 11 heat colours, all others grey.
    const uint legend = DECODE == 12 || DECODE == 11 ? DECODE : kFirstChannel;
    color = vec4(with_legend(clamp(picked, 0.0, 1.0), legend, params.black, params.white, params.size_px), 1.0);
}
