// Adds the light of every source, and of the sky, to the emission that the G-buffer pass left in hdr; pixels without
// a surface show the sky. Output: scene-linear Rec.709, cd/m² × preExposure.
#version 460
#include "brdf.glsl"
#include "frame_set.glsl"
#include "half_float.glsl"
#include "lights.glsl"
#include "octahedral.glsl"
#include "sky.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D albedo;
uniform sampler2D normal;
uniform sampler2D orm;
uniform sampler2D specular;
uniform sampler2D depth;
layout(std430) readonly buffer Lights { Light items[]; } lights;
layout(rgba16f) uniform image2D hdr;

#include "surface_light.glsl"

// Half floats end at 65504; what is brighter stays finite.
const float kMaxStored = 65000.0;

vec3 lit_surface(ivec2 pixel, vec2 uv, float z) {
    const vec3 material = texelFetch(orm, pixel, 0).rgb;
    const vec3 base_root = texelFetch(albedo, pixel, 0).rgb;
    const vec4 coat = texelFetch(specular, pixel, 0);
    const Surface s = make_surface(octahedral_decode(texelFetch(normal, pixel, 0).xy),
                                   base_root * base_root, material.b, material.g, coat.rgb * coat.rgb, coat.a);
    return reflected_radiance(s, world_position(uv, z), material);
}

void main() {
    const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    const ivec2 size = imageSize(hdr);
    if (any(greaterThanEqual(pixel, size))) return;
    const vec2 uv = (vec2(pixel) + 0.5) / vec2(size);
    const float z = texelFetch(depth, pixel, 0).r;
    vec3 color;
    if (z > 0.0) {
        color = imageLoad(hdr, pixel).rgb + lit_surface(pixel, uv, z) * frame.pre_exposure;
    } else {
        color = sky_radiance(ray_direction(uv)) * frame.pre_exposure;
    }
    imageStore(hdr, pixel, vec4(nearest_half(min(color, vec3(kMaxStored))), 1.0));
}
