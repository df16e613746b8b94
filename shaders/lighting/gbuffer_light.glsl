// Deferred lighting of one pixel: adds the light of all sources and of the sky to the emission, which the G-buffer pass
// has written to hdr. A pixel without a surface gets the sky. Output: scene-linear Rec.709, cd/m² × preExposure. Ports:
// those of surface_light.glsl, the G-buffer and hdr. Only compute stages can use this file.
#include "brdf.glsl"
#include "frame_set.glsl"
#include "half_float.glsl"
#include "lights.glsl"
#include "octahedral.glsl"
#include "sky.glsl"
#include "gbuffer_surface.glsl"
#include "surface_light.glsl"

uniform sampler2D depth;
layout(rgba16f) uniform image2D hdr;

// Brighter values are clamped to this number, so that they stay finite: the largest half float is 65504.
const float kMaxStored = 65000.0;

vec3 lit_surface(ivec2 pixel, vec2 uv, float z) {
    const vec3 material = texelFetch(orm, pixel, 0).rgb;
    const vec3 point = world_position(uv, z);
    return reflected_radiance(gbuffer_surface(pixel, material), normalize(view.eye - point), point, material, pixel);
}

void store_light(ivec2 pixel, vec3 color) {
    imageStore(hdr, pixel, vec4(nearest_half(min(color, vec3(kMaxStored))), 1.0));
}

vec3 sky_light(vec2 uv) { return sky_radiance(ray_direction(uv)) * frame.pre_exposure; }

void light_pixel(ivec2 pixel) {
    const vec2 uv = (vec2(pixel) + 0.5) / vec2(imageSize(hdr));
    const float z = texelFetch(depth, pixel, 0).r;
    vec3 color;
    if (z > 0.0) {
        color = imageLoad(hdr, pixel).rgb + lit_surface(pixel, uv, z) * frame.pre_exposure;
    } else {
        color = sky_light(uv);
    }
    store_light(pixel, color);
}
