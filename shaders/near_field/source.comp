// Makes the picture from which the near field (trace.comp) of the next frame reads the light of surfaces. It is the lit
// picture of this frame, with the mean of `nearScale` × `nearScale` pixels in each texel. Scene-linear × preExposure. A
// pixel that is much brighter than the others of its texel counts less, so that a highlight of one pixel does not
// flicker as light on other surfaces.
#version 460
layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D hdr;
layout(rgba16f) writeonly uniform image2D nearSource;

layout(push_constant) uniform Params {
    uint nearScale;
} params;

void main() {
    const ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(texel, imageSize(nearSource)))) return;
    const int side = int(params.nearScale);
    const ivec2 last = textureSize(hdr, 0) - 1;
    vec4 sum = vec4(0.0);
    for (int i = 0; i < side * side; ++i) {
        const vec3 color = texelFetch(hdr, min(texel * side + ivec2(i % side, i / side), last), 0).rgb;
        const float weight = 1.0 / (1.0 + max(color.r, max(color.g, color.b)));
        sum += vec4(color, 1.0) * weight;
    }
    imageStore(nearSource, texel, vec4(sum.rgb / sum.a, 1.0));
}
