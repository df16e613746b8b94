// Counts the pixels of the picture by their EV. Each workgroup counts in shared memory, then adds its counts to the
// buffer. Input hdr: scene-linear values × preExposure. Pixels without light, negative pixels, and pixels that are
// infinite or NaN are not counted.
#version 460
#include "adaptation.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

uniform sampler2D hdr;
buffer Histogram { uint counts[]; } histogram;

layout(push_constant) uniform Params {
    vec2 hdrSize;
    float preExposure;
} params;

shared uint counts[kBins];

void count_pixel(ivec2 pixel) {
    const vec3 color = texelFetch(hdr, pixel, 0).rgb;
    if (any(isnan(color)) || any(isinf(color)) || any(lessThan(color, vec3(0.0)))) return;
    const float luminance = dot(color, vec3(0.2126, 0.7152, 0.0722)) / params.preExposure;
    if (luminance <= 0.0) return;
    const float bin = (log2(luminance / kEv0Luminance) - kLeastEv) * kBinsPerStop;
    atomicAdd(counts[uint(clamp(bin, 0.0, float(kBins - 1u)))], 1u);
}

void main() {
    const uint i = gl_LocalInvocationIndex;
    counts[i] = 0u;
    barrier();
    const ivec2 size = ivec2(params.hdrSize), threads = ivec2(gl_NumWorkGroups.xy * gl_WorkGroupSize.xy);
    for (int y = int(gl_GlobalInvocationID.y); y < size.y; y += threads.y)
        for (int x = int(gl_GlobalInvocationID.x); x < size.x; x += threads.x) count_pixel(ivec2(x, y));
    barrier();
    if (counts[i] > 0u) atomicAdd(histogram.counts[i], counts[i]);
}
