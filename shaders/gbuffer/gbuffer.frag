// G-buffer: what the lighting needs to know of the nearest surface. Emission goes straight into hdr, to which the
// lighting adds in place.
#version 460
#include "frame_set.glsl"
#include "material_set.glsl"
#include "octahedral.glsl"

layout(constant_id = 0) const bool MASKED = false;

layout(location = 0) in vec3 world_normal;
layout(location = 1) in vec4 world_tangent;
layout(location = 2) in vec2 surface_uv;
layout(location = 3) in vec4 clip_now;
layout(location = 4) in vec4 clip_before;

layout(location = 0) out vec4 albedo;    // rgb: √ base colour; drivers differ in how they decode sRGB, roots are exact
layout(location = 1) out vec2 normal;    // octahedral, world space
layout(location = 2) out vec4 orm;       // occlusion, perceptual roughness, metalness
layout(location = 3) out vec4 specular;  // rgb: √F0 of the dielectric, a: specularFactor
layout(location = 4) out vec2 velocity;  // uv now − uv before
layout(location = 5) out vec4 hdr;       // emission × preExposure

vec3 shading_normal() {
    const float facing = gl_FrontFacing ? 1.0 : -1.0;
    const vec3 n = normalize(world_normal) * facing;
    vec3 t = world_tangent.xyz - n * dot(n, world_tangent.xyz);
    const float length2 = dot(t, t);
    if (length2 < 1e-12) return n;
    t *= inversesqrt(length2);
    const vec3 b = cross(n, t) * world_tangent.w * facing;
    vec3 m = texture(normal_texture, transformed(material.normal_uv, surface_uv)).xyz * 2.0 - 1.0;
    m.xy *= material.normal_scale;
    return normalize(t * m.x + b * m.y + n * m.z);
}

void main() {
    const vec4 base =
        texture(base_color_texture, transformed(material.base_color_uv, surface_uv)) * material.base_color;
    if (MASKED && base.a < material.alpha_cutoff) discard;

    const vec3 mr = texture(metallic_roughness_texture, transformed(material.metallic_roughness_uv, surface_uv)).rgb;
    const float ao = texture(occlusion_texture, transformed(material.occlusion_uv, surface_uv)).r;
    const vec3 glow = texture(emissive_texture, transformed(material.emissive_uv, surface_uv)).rgb;

    albedo = vec4(sqrt(base.rgb), 1.0);
    normal = octahedral_encode(shading_normal());
    orm = vec4(mix(1.0, ao, material.occlusion_strength), material.roughness * mr.g, material.metallic * mr.b, 1.0);
    specular = vec4(sqrt(material.dielectric_f0), material.specular);
    velocity = (clip_now.xy / clip_now.w - clip_before.xy / clip_before.w) * 0.5;
    hdr = vec4(min(glow * material.emissive * frame.pre_exposure, vec3(65000.0)), 1.0);
}
