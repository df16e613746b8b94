// Debug view: shows the depth slices of tiles as stripes. The colour shows how many of the 32 slices of the tile
// contain a surface: dark means few slices. Reads the image tileFacts of facts.comp.
#version 460
#include "debug_colors.glsl"
#include "debug_digits.glsl"

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;

uniform sampler2D shown;

#include "tile_view.glsl"

void main() {
    const ivec2 pixel = ivec2(gl_FragCoord.xy);
    const vec4 facts = texelFetch(shown, pixel, 0);
    const vec3 stripe = heat_color(facts.b / 36.0) * (fract(facts.b) > 0.25 ? 1.0 : 0.6);
    color = vec4(with_digits(facts.a > 0.0 ? stripe : vec3(0.0), uint(facts.b), pixel), 1.0);
}
