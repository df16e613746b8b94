// Combines both blurs with the sharp picture, for a pass that blends premultiplied colours. A pixel's own
// depth decides whether it is blurred behind the focus, so edges of sharp surfaces stay sharp. Through the
// blur of a foreground pixel the estimated hidden colour is visible, not the sharp pixel.
#version 460
#include "frame_set.glsl"
#include "circle.glsl"

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 hdr;

uniform sampler2DArray soft;
uniform sampler2D depth;

layout(push_constant) uniform Params { float focus; float aperture; } params;

// Bilinear interpolation, smoothed over two pixels, which hides the gaps between taps.
vec4 smoothed(float layer) {
    const vec2 texel = 1.0 / vec2(textureSize(soft, 0).xy);
    vec4 sum = vec4(0.0);
    for (int i = 0; i < 4; ++i)
        sum += textureLod(soft, vec3(uv + texel * (vec2(i & 1, i >> 1) - 0.5), layer), 0.0) * 0.25;
    return sum;
}

void main() {
    const float radius = circle_radius(texelFetch(depth, ivec2(gl_FragCoord.xy), 0).r, params.focus, params.aperture);
    const vec4 far = smoothed(0.0), close = smoothed(1.0), hidden = smoothed(2.0);
    const vec3 hidden_color = (hidden.rgb + 1e-3 * close.rgb) / max(hidden.a + 1e-3 * close.a, 1e-5);
    const float far_share = far.a > 0.0 ? blurred_share(radius) : 0.0;
    const float close_share = close.a > 0.0 ? blurred_share(-radius) : 0.0;
    const vec4 below = vec4(far.rgb / max(far.a, 1e-4), 1.0) * far_share + vec4(hidden_color, 1.0) * close_share;
    hdr = close + below * (1.0 - close.a);
}
