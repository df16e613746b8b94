// Debug view of the base colours that probes see: a row of six faces for each probe. Bluish: metal.
#version 460
#include "sheet.glsl"

void main() {
    bool exists;
    const vec4 x = sheet_value(6, exists);
    color = vec4(exists ? mix(srgb_encode(x.rgb * x.rgb), vec3(0.2, 0.4, 1.0), 0.25 * x.a) : vec3(0.0), 1.0);
}
