// Converts scene-linear to display values: exposure, a filmic curve, the sRGB transfer function. Output:
// sRGB-encoded [0, 1] for a UNORM target.
#version 460
#include "srgb.glsl"

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 backbuffer;

uniform sampler2D hdr;  // × preExposure

layout(push_constant) uniform Params {
    float exposure;  // in EV, added to the camera's exposure
} params;

void main() {
    const vec3 scene = texelFetch(hdr, ivec2(gl_FragCoord.xy), 0).rgb * exp2(params.exposure);
    backbuffer = vec4(srgb_encode(filmic(scene)), 1.0);
}
