// Combines the blurred layers with the sharp picture. The pass blends premultiplied colours. The depth of a pixel
// itself decides whether the pixel is blurred as background, so the edges of sharp surfaces stay sharp. If the pixel
// itself shows a blurred surface in front of the focus, the estimated hidden colour replaces the sharp colour of the
// pixel.
#version 460
#include "frame_set.glsl"
#include "circle.glsl"

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 hdr;

uniform sampler2DArray soft;
uniform sampler2D depth;

layout(push_constant) uniform Params { float focus; float aperture; } params;

// Returns the mean of four bilinear taps, half a texel left or right of the pixel and half a texel above or below it.
// This smooths the half-size layer.
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
