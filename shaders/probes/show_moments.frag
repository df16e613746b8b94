// Debug view of the octahedral maps of the planes that probes see: a square for each probe. The colour shows the normal
// of the plane, dark planes are far. White: the surfaces deviate much from the plane. Stripes: the probe was not baked
// yet.
#version 460
#include "sheet.glsl"

void main() {
    bool exists;
    const vec4 x = sheet_value(1, exists);
    const float near = length(x.rgb), spread = clamp(x.a / max(near, 1e-6), 0.0, 1.0);
    const vec3 plane = (0.5 - 0.5 * x.rgb / max(near, 1e-6)) * (near / (0.5 + near));
    color = vec4(x.a < 0.0 ? nothing_color(ivec2(gl_FragCoord.xy)) : mix(plane, vec3(1.0), spread), 1.0);
    if (!exists) color.rgb = vec3(0.0);
}
