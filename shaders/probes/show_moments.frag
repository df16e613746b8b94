// Debug view of the octahedral maps of the distances that probes see: a square for each probe. Brightness: the mean
// inverse distance; red: its standard deviation, as a share of the mean. Stripes: the probe was not baked yet.
#version 460
#include "sheet.glsl"

void main() {
    bool exists;
    const vec2 x = sheet_value(1, exists).rg;
    const float light = x.r / (1.0 + x.r), spread = clamp(x.g / max(x.r, 1e-6), 0.0, 1.0);
    color = vec4(x.r < 0.0 ? nothing_color(ivec2(gl_FragCoord.xy)) : light * mix(vec3(1.0), vec3(1.0, 0.2, 0.1), spread), 1.0);
    if (!exists) color.rgb = vec3(0.0);
}
