// Writes the surface that reflects in each texel of the reflections: the first pixel of its `ssrScale` × `ssrScale`
// pixels, never a mean, so that a texel shows one surface. A transparent surface in front of the opaque one replaces it.
// Output ssrSurface: xy: normal in octahedral encoding; z: reversed depth, 0 for the sky; w: roughness, kNoRays for a
// surface without rays. Output ssrTileClass: 1 if a texel of the tile has rays, otherwise 0.
#version 460
#include "tiles.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(constant_id = 1) const bool HAS_ssrGlassDepth = false;
layout(constant_id = 2) const bool HAS_ssrGlass = false;
uniform sampler2D depth;
uniform sampler2D normal;
uniform sampler2D orm;
uniform sampler2D ssrGlassDepth;
uniform sampler2D ssrGlass;
layout(rgba32f) writeonly uniform image2D ssrSurface;
layout(r32ui) writeonly uniform uimage2D ssrTileClass;

layout(push_constant) uniform Params {
    uint ssrScale;
    float ssrRoughest;  // Surfaces with a larger roughness have no rays.
    uint ssrOpaque;     // 0: only transparent surfaces have rays.
} params;

shared uint any_rays;

vec4 surface_of(ivec2 texel) {
    const ivec2 pixel = min(texel * int(params.ssrScale), textureSize(depth, 0) - 1);
    vec4 surface = vec4(texelFetch(normal, pixel, 0).xy, texelFetch(depth, pixel, 0).r, texelFetch(orm, pixel, 0).g);
    if (params.ssrOpaque == 0u) surface.w = kNoRays;
    if (HAS_ssrGlassDepth) {
        const float z = texelFetch(ssrGlassDepth, pixel, 0).r;
        if (z > surface.z) surface = vec4(texelFetch(ssrGlass, pixel, 0).xy, z, texelFetch(ssrGlass, pixel, 0).z);
    }
    if (surface.w > params.ssrRoughest) surface.w = kNoRays;
    return surface;
}

void main() {
    const ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (gl_LocalInvocationIndex == 0u) any_rays = 0u;
    barrier();
    if (all(lessThan(texel, imageSize(ssrSurface)))) {
        const vec4 surface = surface_of(texel);
        imageStore(ssrSurface, texel, surface);
        if (surface.z > 0.0 && surface.w < kNoRays) atomicOr(any_rays, 1u);
    }
    barrier();
    if (gl_LocalInvocationIndex == 0u) imageStore(ssrTileClass, ivec2(gl_WorkGroupID.xy), uvec4(any_rays));
}
