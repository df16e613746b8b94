// Shows a buffer's words as floats, row after row, from the top left.
// Output: sRGB-encoded [0, 1]. DECODE is the place of a name in debug_decoders().
#version 460
#include "debug_colors.glsl"
#include "debug_digits.glsl"
#include "frame_set.glsl"
#include "debug_legend.glsl"

layout(constant_id = 0) const uint DECODE = 11;

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;

readonly buffer Shown { float items[]; } shown;

layout(push_constant) uniform Params {
    float black, white;  // what is shown as 0 and as 1
} params;

void main() {
    const uint count = shown.items.length();
    const uint side = uint(ceil(sqrt(float(count))));
    const uvec2 at = uvec2(uv * float(side));
    const uint i = at.y * side + at.x;
    if (i >= count) {
        color = vec4(0.1, 0.1, 0.1, 1.0);  // behind the end
        return;
    }
    const float y = (float(shown.items[i]) - params.black) / (params.white - params.black);
    const vec3 picked = DECODE == 12 ? index_color(uint(shown.items[i])) : DECODE == 11 ? heat_color(y) : vec3(y);
    // Every decoder but "index" shows a buffer as heat or as grey.
    const uint legend = DECODE == 12 || DECODE == 11 ? DECODE : kFirstChannel;
    color = vec4(with_legend(clamp(picked, 0.0, 1.0), legend, params.black, params.white), 1.0);
}
