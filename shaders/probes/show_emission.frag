// Debug view of the light that surfaces around the probes emit: a row of six faces for each probe. Middle grey is about
// 500 cd/m².
#version 460
#include "shared/probe_grid.glsl"
#include "sheet.glsl"

void main() {
    bool exists;
    const vec3 x = sheet_value(6, exists).rgb / (500.0 * kProbeRadianceScale);
    color = vec4(exists ? srgb_encode(x / (4.0 + x)) : vec3(0.0), 1.0);
}
