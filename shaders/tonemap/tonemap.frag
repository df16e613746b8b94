// Scene-linear to display: exposure, a filmic curve, the sRGB transfer function.
// Curve: Narkowicz 2016, "ACES Filmic Tone Mapping Curve", a fit to the ACES reference rendering transform.
// IEC 61966-2-1 for the encoding. Output: sRGB-encoded [0, 1] for a UNORM target.
#version 460

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 backbuffer;

uniform sampler2D hdr;  // × preExposure

layout(push_constant) uniform Params {
    float exposure;  // EV on top of the camera's
} params;

vec3 filmic(vec3 x) {
    return clamp((x * (2.51 * x + 0.03)) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0);
}

vec3 srgb_encode(vec3 c) {
    return mix(1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, 12.92 * c, lessThanEqual(c, vec3(0.0031308)));
}

void main() {
    const vec3 scene = texelFetch(hdr, ivec2(gl_FragCoord.xy), 0).rgb * exp2(params.exposure);
    backbuffer = vec4(srgb_encode(filmic(scene)), 1.0);
}
