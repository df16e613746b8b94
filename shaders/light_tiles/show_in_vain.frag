// Debug view: shows for each tile how many of its listed lights reach no surface. Darker lines are the edges of
// surfaces. Reads the image tileFacts of facts.comp.
#version 460
#include "debug_colors.glsl"
#include "debug_digits.glsl"

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;

uniform sampler2D shown;

#include "tile_view.glsl"

void main() {
    const ivec2 pixel = ivec2(gl_FragCoord.xy);
    const float number = texelFetch(shown, pixel, 0).g;
    const vec3 heat = number_color(number, pixel);
    color = vec4(with_key(with_digits(heat, uint(number), pixel), pixel, textureSize(shown, 0)), 1.0);
}
