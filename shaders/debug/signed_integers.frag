// Debug view of an image of signed integers. Output: sRGB-encoded colours in [0, 1]. DECODE selects how values become
// colours: it is an index into debug_decoders() in C++.
#version 460
#include "debug_colors.glsl"
#include "debug_digits.glsl"
#include "debug_legend.glsl"

layout(constant_id = 0) const uint DECODE = 12;
layout(constant_id = 1) const bool HAS_surface = false;

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;

uniform isampler2D shown;
// The depth attachment of the pass that drew `shown`. Pixels with depth 0 (nothing drawn) get stripes.
uniform sampler2D surface;

layout(push_constant) uniform Params {
    float black, white;  // The values that are shown as black and as white.
    // Size of the part of `shown` that has content, in texture coordinates. The same part of `surface` has content.
    vec2 shownUv;
    vec2 size_px;  // The size of the debug view.
} params;

void main() {
    const ivec4 x = texelFetch(shown, ivec2(uv * params.shownUv * vec2(textureSize(shown, 0))), 0);
    const vec4 y = (vec4(x) - params.black) / (params.white - params.black);
    const vec3 picked = DECODE == 12   ? index_color(uint(x.r))
                        : DECODE == 11 ? heat_color(y.r)
                        : DECODE == 7  ? y.rrr
                        : DECODE == 8  ? y.ggg
                        : DECODE == 9  ? y.bbb
                        : DECODE == 10 ? y.aaa
                                       : y.rgb;
    const bool nothing = HAS_surface && textureLod(surface, uv * params.shownUv, 0.0).r <= 0.0;
    const vec3 seen = nothing ? nothing_color(ivec2(gl_FragCoord.xy)) : clamp(picked, 0.0, 1.0);
    color = vec4(with_legend(seen, DECODE, params.black, params.white, params.size_px), 1.0);
}
