// Adds the light that reaches every pixel: directional lights and the sky. The image hdr already contains the emission
// and the light of the light volumes. Pixels without a surface get the sky. Output: scene-linear Rec.709, cd/m² ×
// preExposure.
#version 460
layout(local_size_x = 8, local_size_y = 8) in;

#include "gbuffer_light.glsl"

vec3 lit_from_afar(ivec2 pixel, vec3 position) {
    const vec3 material = texelFetch(orm, pixel, 0).rgb;
    const vec3 v = normalize(view.eye - position);
    const Surface s = with_albedo(gbuffer_surface(pixel, material), v);
    return directional_reflection(s, v, position) + material.r * ambient_reflection(s, v, material.g, position, pixel);
}

void main() {
    const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    const ivec2 size = imageSize(hdr);
    if (any(greaterThanEqual(pixel, size))) return;
    const vec2 uv = (vec2(pixel) + 0.5) / vec2(size);
    const float z = texelFetch(depth, pixel, 0).r;
    vec3 color;
    if (z > 0.0) {
        color = imageLoad(hdr, pixel).rgb + lit_from_afar(pixel, world_position(uv, z)) * frame.pre_exposure;
    } else {
        color = sky_light(uv);
    }
    store_light(pixel, color);
}
