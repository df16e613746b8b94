// Reads the material of a fragment: the interpolated outputs of surface_vertex.glsl and the textures of the material.
// Only fragment stages can use this file.
#ifndef WEFT_SURFACE_FRAGMENT
#define WEFT_SURFACE_FRAGMENT
#include "frame_set.glsl"
#include "material_set.glsl"

layout(location = 0) in vec3 world_normal;
layout(location = 1) in vec4 world_tangent;
layout(location = 2) in vec2 surface_uv;
layout(location = 3) in vec2 surface_second_uv;
layout(location = 4) in vec4 color_lack;

vec2 texture_uv(TextureTransform transform) {
    return transformed(transform, transform.row0.w > 0.0 ? surface_second_uv : surface_uv);
}

// Clamps the colour, because interpolation may give values slightly outside [0, 1].
vec4 vertex_color() { return clamp(1.0 - color_lack, 0.0, 1.0); }

vec4 base_color() {
    return texture(base_color_texture, texture_uv(material.base_color_uv), view.mip_bias) * material.base_color * vertex_color();
}

// Returns the normal of the mesh, without the normal map.
vec3 mesh_normal() { return normalize(world_normal) * (gl_FrontFacing ? 1.0 : -1.0); }

// Transforms a normal `m` from the space of the normal map to world space.
vec3 world_normal_of(vec3 m) {
    const float facing = gl_FrontFacing ? 1.0 : -1.0;
    const vec3 n = mesh_normal();
    vec3 t = world_tangent.xyz - n * dot(n, world_tangent.xyz);
    const float length2 = dot(t, t);
    if (length2 < 1e-12) return n;
    t *= inversesqrt(length2);
    const vec3 b = cross(n, t) * world_tangent.w * facing;
    return normalize(t * m.x + b * m.y + n * m.z);
}

vec3 shading_normal() {
    vec3 m = texture(normal_texture, texture_uv(material.normal_uv), view.mip_bias).xyz * 2.0 - 1.0;
    m.xy *= material.normal_scale;
    return world_normal_of(m);
}

// Returns the perceptual roughness with which one sample has about the mean highlight of the pixel. The normals in a
// pixel of a curved surface differ, so the highlight can be smaller than the pixel and flicker. `dx`, `dy`: the change of
// the normal from this pixel to the next one. Normals that are evenly distributed over a change d have the variance
// d² / 12. A GGX lobe is as wide as normals of the variance α² / 2, so α² grows by d² / 6; here by the mean for both
// directions. With temporal anti-aliasing, a sample stands for a smaller part of the pixel; see view.mip_bias. Source:
// Kaplanyan et al. 2016, "Filtering Distributions of Normals for Shading Antialiasing", with the upper limit of Tokuyoshi
// and Kaplanyan 2019, "Improved Geometric Specular Antialiasing".
float roughness_of_pixel(float roughness, vec3 dx, vec3 dy) {
    const float kMostWidening = 0.18;
    const float alpha = roughness * roughness;
    const float side = exp2(view.mip_bias);  // Of the part of the pixel, in pixels.
    const float widening = min(side * side * (dot(dx, dx) + dot(dy, dy)) / 12.0, kMostWidening);
    return sqrt(sqrt(min(alpha * alpha + widening, 1.0)));
}

// Returns r: occlusion, g: perceptual roughness, b: metalness.
vec3 occlusion_roughness_metalness() {
    const vec3 mr = texture(metallic_roughness_texture, texture_uv(material.metallic_roughness_uv), view.mip_bias).rgb;
    const float ao = texture(occlusion_texture, texture_uv(material.occlusion_uv), view.mip_bias).r;
    return vec3(mix(1.0, ao, material.occlusion_strength), material.roughness * mr.g, material.metallic * mr.b);
}

// Returns the anisotropy of the material (KHR_materials_anisotropy). xyz: the unit vector, perpendicular to `n`, along
// which the surface is rougher; w: strength.
vec4 anisotropy(vec3 n) {
    const vec3 texel = texture(anisotropy_texture, texture_uv(material.anisotropy_uv), view.mip_bias).rgb;
    const vec2 grain = material.anisotropy_textured > 0.0 ? texel.rg * 2.0 - 1.0 : vec2(1.0, 0.0);
    const vec2 turn = material.anisotropy_turn;
    const vec2 turned = mat2(turn, -turn.y, turn.x) * grain;
    const vec3 any = abs(n.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0);  // Replaces a missing tangent.
    vec3 t = world_tangent.xyz - n * dot(n, world_tangent.xyz);
    if (dot(t, t) < 1e-12) t = cross(any, n);
    t = normalize(t);
    const vec3 b = cross(n, t) * world_tangent.w * (gl_FrontFacing ? 1.0 : -1.0);
    const vec3 direction = t * turned.x + b * turned.y;
    const float length2 = dot(direction, direction);
    return vec4(length2 > 1e-12 ? direction * inversesqrt(length2) : t, material.anisotropy * texel.b);
}

// Returns the colour with which the surface reflects light that it does not let pass (material.diffuse_share). `base`: the
// base colour.
vec3 reflected_color(vec3 base, float metalness) { return base * mix(material.diffuse_share, 1.0, metalness); }

// Returns the luminance that the surface emits, in cd/m².
vec3 emission() {
    const vec3 tint = mix(vec3(1.0), vertex_color().rgb, material.emission_tint);
    return texture(emissive_texture, texture_uv(material.emissive_uv), view.mip_bias).rgb * material.emissive * tint;
}
#endif
