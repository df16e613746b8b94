// Converts scene-linear values to display values: exposure, a filmic curve and the sRGB encoding. Output: [0, 1],
// encoded for a UNORM target.
#version 460
#include "exposure.glsl"
#include "srgb.glsl"

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 backbuffer;

uniform sampler2D hdr;  // Scene-linear values × preExposure.

layout(push_constant) uniform Params {
    float exposure;  // In EV, added to the exposure of the camera.
    float preExposure, adaptationValid;
} params;

void main() {
    const float ev = params.exposure + automatic_ev(params.adaptationValid, params.preExposure);
    const vec3 scene = texelFetch(hdr, ivec2(gl_FragCoord.xy), 0).rgb * exp2(ev);
    backbuffer = vec4(srgb_encode(filmic(scene)), 1.0);
}
