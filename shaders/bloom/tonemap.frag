// Mixes the picture with a blurred picture, which is the light that the lens scatters, and converts the result to
// display values, as tonemap/tonemap.frag does. Output: [0, 1], encoded for a UNORM target.
#version 460
#include "exposure.glsl"
#include "srgb.glsl"
#include "tent.glsl"

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 backbuffer;

uniform sampler2D hdr;    // Scene-linear values × preExposure.
uniform sampler2D bloom;  // The blurred picture.

layout(push_constant) uniform Params {
    float exposure;       // In EV, added to the exposure of the camera.
    float bloomStrength;  // Share of the light that the lens scatters, 0 to 1.
    float preExposure, adaptationValid;
} params;

void main() {
    const float ev = params.exposure + automatic_ev(params.adaptationValid, params.preExposure);
    const vec3 picture = texelFetch(hdr, ivec2(gl_FragCoord.xy), 0).rgb;
    const vec3 scene = mix(picture, tent(bloom, uv), params.bloomStrength) * exp2(ev);
    backbuffer = vec4(srgb_encode(filmic(scene)), 1.0);
}
