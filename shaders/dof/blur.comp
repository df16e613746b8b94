// Blurs the half-size layers: each pixel gets the light of all pixels whose circle of confusion covers it. Colours are
// premultiplied. Output layer 0: surfaces behind the focus; layer 1: surfaces in front of the focus, with their
// coverage as alpha; layer 2: an estimate of the colours that layer 1 hides, computed from visible neighbours.
#version 460
#include "frame_set.glsl"
#include "half_float.glsl"
#include "circle.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D behind;
uniform sampler2D before;
uniform sampler2D hidden;
uniform sampler2D circles;
uniform sampler2D reach;
layout(rgba16f) writeonly uniform image2DArray soft;

const float kPi = 3.14159265358979;

// The loops below read every texel in range, unfiltered. A lamp is a few texels wide and a thousand times as bright as
// the sky. Taps that skip texels would hit the lamp from one pixel and miss it from the next. Filtered taps would
// combine the light of the lamp with the radius of the sky's circles. Both would cause sparks around lamps.
ivec2 inside(ivec2 at) { return clamp(at, ivec2(0), textureSize(circles, 0) - 1); }

// Returns the share of a pixel's light that another pixel at this distance receives. The light is spread evenly over
// the circle, whose soft edge is one pixel wide. The shares that all pixels receive add up to about 1.
float share(float radius, float distance_px) {
    const float wide = max(radius, 0.5);
    return clamp(wide - distance_px + 0.5, 0.0, 1.0) / (kPi * (wide * wide + 1.0 / 12.0));
}

// Returns half the width of row `y` of a disc with this radius.
int row_reach(float radius, int y) { return int(sqrt(max(radius * radius - float(y * y), 0.0))); }

vec4 far_light(ivec2 pixel) {
    float radius = 0.5;
    for (int i = 0; i < 9; ++i)
        radius = max(radius, texelFetch(circles, inside(pixel + ivec2(i % 3, i / 3) - 1), 0).r);
    radius += 0.5;
    const int rows = int(radius);
    vec4 sum = texelFetch(behind, pixel, 0) * 1e-5;
    for (int y = -rows; y <= rows; ++y) {
        const int columns = row_reach(radius, y);
        for (int x = -columns; x <= columns; ++x) {
            const ivec2 at = inside(pixel + ivec2(x, y));
            sum += texelFetch(behind, at, 0) * share(texelFetch(circles, at, 0).r, length(vec2(x, y)));
        }
    }
    return sum.a > 0.0 ? vec4(sum.rgb / sum.a, 1.0) * min(1.0, sum.a * 100.0) : vec4(0.0);
}

struct Foreground {
    vec4 light;
    vec4 below;
};

Foreground close_light(ivec2 pixel) {
    const float reached = texelFetch(reach, pixel / 8, 0).r, radius = reached + 0.5;
    const int rows = reached > 0.25 ? int(radius) : -1;
    Foreground f = Foreground(vec4(0.0), vec4(0.0));
    for (int y = -rows; y <= rows; ++y) {
        const int columns = row_reach(radius, y);
        for (int x = -columns; x <= columns; ++x) {
            const ivec2 at = inside(pixel + ivec2(x, y));
            const float distance2 = float(x * x + y * y);
            f.light += texelFetch(before, at, 0) * share(texelFetch(circles, at, 0).g, sqrt(distance2));
            // The estimate is a weighted mean. Close neighbours have the highest weight, so that the estimate continues
            // the visible colours without an edge.
            f.below += texelFetch(hidden, at, 0) / (1.0 + distance2 * distance2);
        }
    }
    f.light /= max(1.0, f.light.a);
    return f;
}

void main() {
    const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    const ivec2 size = imageSize(soft).xy;
    if (any(greaterThanEqual(pixel, size))) return;
    const vec4 far = far_light(pixel);
    const Foreground close = close_light(pixel);
    imageStore(soft, ivec3(pixel, 0), vec4(nearest_half(far.rgb), far.a));
    imageStore(soft, ivec3(pixel, 1), vec4(nearest_half(close.light.rgb), close.light.a));
    imageStore(soft, ivec3(pixel, 2), vec4(nearest_half(close.below.rgb), close.below.a));
}
