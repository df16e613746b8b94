// Debug view of the light that reflection probes see: a row of six faces for each probe, with a tone curve that fits the
// mean of all probes.
#version 460
#include "sheet.glsl"

void main() {
    bool exists;
    const vec3 light = sheet_value(6, exists).rgb;
    const ivec3 size = textureSize(shown, 0);
    float sum = 0.0;
    const int kSamples = 96;
    for (int i = 0; i < kSamples; ++i) {
        const ivec2 at = ivec2(fract(vec2(0.754877666, 0.569840291) * float(i)) * vec2(size.xy));
        sum += dot(texelFetch(shown, ivec3(at, i * size.z / kSamples), 0).rgb, vec3(0.2126, 0.7152, 0.0722));
    }
    const float middle = max(sum / float(kSamples), 1e-7);
    color = vec4(exists ? srgb_encode(light / (light + middle)) : vec3(0.0), 1.0);
}
