// Shows the two chemicals of `cells` as a glazed relief. The second chemical, v, is the height of the relief. The light
// comes from the upper left, and high parts are glossy.
#version 460
#include "srgb.glsl"

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 backbuffer;

uniform sampler2D cells;

// Reads the cells with B-spline interpolation from four bilinear taps. This hides the corners of cells at any
// magnification. Source: Sigg and Hadwiger 2005, "Fast Third-Order Texture Filtering".
vec2 smooth_cells(vec2 place) {
    const vec2 size = vec2(textureSize(cells, 0));
    const vec2 texel = place * size - 0.5, cell = floor(texel), f = texel - cell;
    const vec2 f2 = f * f, f3 = f2 * f;
    const vec2 w0 = (1.0 - f) * (1.0 - f) * (1.0 - f) / 6.0, w1 = (4.0 - 6.0 * f2 + 3.0 * f3) / 6.0, w3 = f3 / 6.0;
    const vec2 low = w0 + w1, high = 1.0 - low;
    const vec2 a = (cell + w1 / low - 0.5) / size, b = (cell + w3 / high + 1.5) / size;
    return (textureLod(cells, a, 0.0).rg * low.x + textureLod(cells, vec2(b.x, a.y), 0.0).rg * high.x) * low.y +
           (textureLod(cells, vec2(a.x, b.y), 0.0).rg * low.x + textureLod(cells, b, 0.0).rg * high.x) * high.y;
}

vec3 enamel(float v, float u) {
    const vec3 deep = vec3(0.004, 0.012, 0.035), sea = vec3(0.0, 0.11, 0.16), shore = vec3(0.03, 0.42, 0.36),
               cream = vec3(0.95, 0.78, 0.52), coral = vec3(0.85, 0.16, 0.06);
    vec3 color = mix(deep, sea, smoothstep(0.0, 0.10, v));
    color = mix(color, shore, smoothstep(0.08, 0.19, v));
    color = mix(color, cream, smoothstep(0.19, 0.29, v));
    return mix(color, coral, smoothstep(0.30, 0.38, v));
}

void main() {
    const vec2 texel = 0.75 / vec2(textureSize(cells, 0));
    const vec2 here = smooth_cells(uv);
    const vec2 slope = vec2(smooth_cells(uv + vec2(texel.x, 0.0)).y - smooth_cells(uv - vec2(texel.x, 0.0)).y,
                            smooth_cells(uv + vec2(0.0, texel.y)).y - smooth_cells(uv - vec2(0.0, texel.y)).y);
    const vec3 n = normalize(vec3(-slope * 14.0, 1.0));
    const vec3 to_light = normalize(vec3(-0.5, -0.65, 0.7)), h = normalize(to_light + vec3(0.0, 0.0, 1.0));
    const float lit = max(dot(n, to_light), 0.0);
    const float shine = pow(max(dot(n, h), 0.0), 60.0) * smoothstep(0.05, 0.2, here.y);
    const vec2 from_middle = uv - 0.5;
    const float rim = 1.0 - 0.9 * dot(from_middle, from_middle);
    const vec3 color = (enamel(here.y, here.x) * (0.25 + 1.15 * lit) + vec3(1.0, 0.93, 0.8) * shine * 0.55) * rim;
    backbuffer = vec4(srgb_encode(filmic(color * 0.85)), 1.0);
}
