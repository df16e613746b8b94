// Debug view of the normals that probes see: a row of six faces for each probe.
#version 460
#include "octahedral.glsl"
#include "sheet.glsl"

void main() {
    bool exists;
    const vec2 x = sheet_value(6, exists).rg;
    color = vec4(exists ? octahedral_decode(x) * 0.5 + 0.5 : vec3(0.0), 1.0);
}
