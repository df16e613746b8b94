// Debug view of the distances that probes see: a row of six faces for each probe. Near surfaces are light, and a surface at
// 1 m has half the brightness of the brightest. Red: the inside of an object. Stripes: nothing is there.
#version 460
#include "sheet.glsl"

void main() {
    bool exists;
    const float x = sheet_value(6, exists).r;
    const float light = 1.0 / (1.0 + abs(x));
    const vec3 tint = x < 0.0 ? vec3(1.0, 0.15, 0.1) : vec3(1.0);
    color = vec4(x == 0.0 ? nothing_color(ivec2(gl_FragCoord.xy)) : light * tint, 1.0);
    if (!exists) color.rgb = vec3(0.0);
}
