// Debug view of an image that shaders sample as floats (float, normalised or depth format). Output: sRGB-encoded
// colours in [0, 1]. DECODE selects how values become colours: it is an index into debug_decoders() in C++.
#version 460
#include "debug_colors.glsl"
#include "debug_digits.glsl"
#include "frame_set.glsl"
#include "debug_legend.glsl"
#include "octahedral.glsl"
#include "srgb.glsl"

layout(constant_id = 0) const uint DECODE = 0;
layout(constant_id = 1) const bool HAS_surface = false;

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;

uniform sampler2D shown;
// The depth attachment of the pass that drew `shown`. Pixels with depth 0 (nothing drawn) get stripes.
uniform sampler2D surface;

layout(push_constant) uniform Params {
    // The values that are shown as black and as white. For depth (DECODE 5), this is reversed: `black` is the value of
    // the nearest distance, which is shown as white, and `white` is the value of the farthest distance, which is shown
    // as black. Both values are log2(1 + distance in metres).
    float black, white;
    // Size of the part of `shown` that has content, in texture coordinates. The same part of `surface` has content.
    vec2 shownUv;
    vec2 size_px;  // The size of the debug view.
} params;

float ranged(float x) { return (x - params.black) / (params.white - params.black); }

// Converts the depth of the view that drew `shown` to grey, on a logarithmic scale of the distance in metres. The
// inverse of the projection also works for mirrors, whose near plane is the mirror. A parallel projection has no
// viewpoint, so the distance is measured from its near plane.
vec3 depth_color(float z) {
    if (z <= 0.0) return nothing_color(ivec2(gl_FragCoord.xy));
    const mat4 to_view = inverse(view.projection);
    const vec4 place = to_view * vec4(uv * 2.0 - 1.0, z, 1.0);
    const float origin = view.projection[2][3] == 0.0 ? (to_view * vec4(uv * 2.0 - 1.0, 1.0, 1.0)).z : 0.0;
    return vec3(1.0 - ranged(log2(1.0 + max(origin - place.z / place.w, 0.0))));
}

vec3 decoded(vec4 x) {
    switch (DECODE) {
        case 0: return srgb_encode(filmic(x.rgb));
        case 1: return vec3(ranged(x.r), ranged(x.g), ranged(x.b));
        case 2: return srgb_encode(x.rgb * x.rgb);
        case 3: return octahedral_decode(x.rg) * 0.5 + 0.5;
        case 4: return x.rgb * 0.5 + 0.5;
        case 5: return depth_color(x.r);
        case 6: return vector_color(x.rg / max(params.white, 1e-9));
        case 7: return vec3(ranged(x.r));
        case 8: return vec3(ranged(x.g));
        case 9: return vec3(ranged(x.b));
        case 10: return vec3(ranged(x.a));
        case 11: return heat_color(ranged(x.r));
        default: return index_color(uint(max(x.r, 0.0)));
    }
}

void main() {
    const vec4 x = texture(shown, uv * params.shownUv);
    const bool odd = any(isnan(x)) || any(isinf(x));
    const bool nothing = HAS_surface && textureLod(surface, uv * params.shownUv, 0.0).r <= 0.0;
    // NaN and infinity are shown in magenta, because they are usually errors.
    const vec3 picked = odd ? vec3(1.0, 0.0, 1.0) : nothing ? nothing_color(ivec2(gl_FragCoord.xy)) : clamp(decoded(x), 0.0, 1.0);
    color = vec4(with_legend(picked, DECODE, params.black, params.white, params.size_px), 1.0);
}
