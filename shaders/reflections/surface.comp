// Writes the surface that reflects in each texel of the reflections: the first pixel of its `ssrScale` × `ssrScale`
// pixels, never a mean, so that a texel shows one surface. A transparent surface in front of the opaque one replaces it.
// Output ssrSurface: xy: normal in octahedral encoding; z: reversed depth, 0 for the sky; w: roughness.
#version 460
layout(local_size_x = 8, local_size_y = 8) in;

layout(constant_id = 1) const bool HAS_ssrGlassDepth = false;
layout(constant_id = 2) const bool HAS_ssrGlass = false;
uniform sampler2D depth;
uniform sampler2D normal;
uniform sampler2D orm;
uniform sampler2D ssrGlassDepth;
uniform sampler2D ssrGlass;
layout(rgba32f) writeonly uniform image2D ssrSurface;

layout(push_constant) uniform Params {
    uint ssrScale;
} params;

void main() {
    const ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(texel, imageSize(ssrSurface)))) return;
    const ivec2 pixel = min(texel * int(params.ssrScale), textureSize(depth, 0) - 1);
    vec4 surface = vec4(texelFetch(normal, pixel, 0).xy, texelFetch(depth, pixel, 0).r, texelFetch(orm, pixel, 0).g);
    if (HAS_ssrGlassDepth) {
        const float z = texelFetch(ssrGlassDepth, pixel, 0).r;
        if (z > surface.z) surface = vec4(texelFetch(ssrGlass, pixel, 0).xy, z, texelFetch(ssrGlass, pixel, 0).z);
    }
    imageStore(ssrSurface, texel, surface);
}
