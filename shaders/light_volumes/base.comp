// The light that reaches every pixel: what directional lights and the sky send is added to the emission and to what the
// proxies have added to it; pixels without a surface show the sky. Output: scene-linear Rec.709, cd/m² × preExposure.
#version 460
#include "brdf.glsl"
#include "frame_set.glsl"
#include "half_float.glsl"
#include "lights.glsl"
#include "octahedral.glsl"
#include "sky.glsl"
#include "gbuffer_surface.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D depth;
layout(std430) readonly buffer Lights { Light items[]; } lights;
layout(rgba16f) uniform image2D hdr;

#include "light_reflection.glsl"
#include "directional_lights.glsl"

const float kMaxStored = 65000.0;

vec3 lit_surface(ivec2 pixel, vec3 position) {
    const vec3 material = texelFetch(orm, pixel, 0).rgb;
    const Surface s = gbuffer_surface(pixel, material);
    const vec3 v = normalize(view.eye - position);
    return directional_reflection(s, v, position) +
           material.r * ambient_reflection(s.normal, v, s.diffuse, s.f0, s.f90, material.g);
}

void main() {
    const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    const ivec2 size = imageSize(hdr);
    if (any(greaterThanEqual(pixel, size))) return;
    const vec2 uv = (vec2(pixel) + 0.5) / vec2(size);
    const float z = texelFetch(depth, pixel, 0).r;
    vec3 color;
    if (z > 0.0) {
        color = imageLoad(hdr, pixel).rgb + lit_surface(pixel, world_position(uv, z)) * frame.pre_exposure;
    } else {
        color = sky_radiance(ray_direction(uv)) * frame.pre_exposure;
    }
    imageStore(hdr, pixel, vec4(nearest_half(min(color, vec3(kMaxStored))), 1.0));
}
