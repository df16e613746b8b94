// Splits the picture into three half-size layers: surfaces behind the focus, surfaces in front of it, and surfaces that
// the front layer may hide. For the first two layers, each colour is multiplied by blurred_share() before averaging, so
// sharp surfaces have no weight in these layers. Source: Liu 2016, "Rendering 'Monster Hunter Online'".
//
// Each pixel also stores one circle radius behind and one in front of the focus. Each radius is a mean over four
// full-size pixels, weighted by their light. If a lamp and the sky share a pixel, nearly all light comes from the lamp.
// This light then spreads over the small circle of the lamp, and not over the larger circle of the sky.
#version 460
#include "frame_set.glsl"
#include "half_float.glsl"
#include "circle.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D hdr;
uniform sampler2D depth;
layout(rgba16f) writeonly uniform image2D behind;
layout(rgba16f) writeonly uniform image2D before;
layout(rgba16f) writeonly uniform image2D hidden;
layout(rg16f) writeonly uniform image2D circles;  // Radii in half-size pixels. r: behind the focus, g: before it.

layout(push_constant) uniform Params { float focus; float aperture; } params;

// Returns the weight of a pixel in the mean radius: the brightness of the pixel. Black pixels have a small weight, too.
float weight(vec4 color) { return dot(color.rgb, vec3(0.25, 0.5, 0.25)) + 1e-4 * color.a; }

void main() {
    const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(behind)))) return;
    const ivec2 last = textureSize(hdr, 0) - 1;
    vec4 far = vec4(0.0), close = vec4(0.0), rest = vec4(0.0);
    vec2 radii = vec2(0.0), weights = vec2(0.0);
    for (int i = 0; i < 4; ++i) {
        const ivec2 at = min(pixel * 2 + ivec2(i & 1, i >> 1), last);
        const float radius = circle_radius(texelFetch(depth, at, 0).r, params.focus, params.aperture);
        const vec4 color = vec4(texelFetch(hdr, at, 0).rgb, 1.0) * 0.25;
        const vec2 blurred = vec2(blurred_share(radius), blurred_share(-radius));
        far += color * blurred.x;
        close += color * blurred.y;
        rest += color * (1.0 - blurred.y);
        weights += weight(color) * blurred;
        radii += weight(color) * blurred * abs(radius);
    }
    imageStore(behind, pixel, vec4(nearest_half(far.rgb), far.a));
    imageStore(before, pixel, vec4(nearest_half(close.rgb), close.a));
    imageStore(hidden, pixel, vec4(nearest_half(rest.rgb), rest.a));
    imageStore(circles, pixel, vec4(radii / max(weights, vec2(1e-12)), 0.0, 0.0));
}
