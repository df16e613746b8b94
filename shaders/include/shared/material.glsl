// A material: in descriptor set 2, and an element of the imported buffer `materials`.
// Texture transform: uv' = (row0·(u,v,1), row1·(u,v,1)).
#ifndef WEFT_SHARED_MATERIAL
#define WEFT_SHARED_MATERIAL
#include "begin.glsl"

struct TextureTransform {
    vec4 row0;               // row0.w: index of the uv set that is transformed, 0 or 1.
    vec4 row1;
};

struct Material {
    vec4 base_color;
    vec3 emissive;           // Emitted luminance, in cd/m².
    float alpha_cutoff;
    vec3 dielectric_f0;      // Reflectance at 0°: ((ior − 1)/(ior + 1))² · specularColor, at most 1.
    float specular;          // specularFactor of KHR_materials_specular.
    float metallic;
    float roughness;         // Perceptual roughness, 0 to 1.
    float normal_scale;
    float occlusion_strength;
    TextureTransform base_color_uv;
    TextureTransform metallic_roughness_uv;
    TextureTransform normal_uv;
    TextureTransform occlusion_uv;
    TextureTransform emissive_uv;
    float emission_tint;     // 1: vertex colours also multiply the emission.
    float anisotropy;        // Strength of the anisotropy, 0 to 1.
    vec2 anisotropy_turn;    // Cosine and sine of the angle from the tangent to the grain's direction.
    TextureTransform anisotropy_uv;
    float anisotropy_textured;  // 1: a texture gives the direction; 0: the direction is the tangent.
    // Numbers of the textures in the imported table of textures `materialTextures`. A material without a texture has
    // the number of a texture of one texel: white, or the flat normal (0.5, 0.5, 1).
    uint base_color_texture;
    uint metallic_roughness_texture;
    uint normal_texture;
    uint occlusion_texture;
    uint emissive_texture;
    uint anisotropy_texture;
    uint two_sided;          // 1: both sides of the surface look the same (doubleSided in glTF).
    vec3 absorption_per_m;   // Of the body behind the surface: it lets exp(−absorption · distance) pass.
    float transmission;      // Share of the light that passes through the surface, of that which is not mirrored.
    vec4 ripples;            // xy, zw: velocities of the two layers of the normal map, in uv/s. 0: one layer, still.
    float thickness_m;       // Of the body behind the surface, along the normal; 0: thin.
    float ior;               // Index of refraction.
    float clearcoat;         // Share of the surface with a clear coat, 0 to 1.
    float clearcoat_roughness;  // Perceptual roughness of the coat, 0 to 1.
    vec3 transmitted_color;  // Scattered light at the front of the surface, for uniform light from behind of 1.
    float diffuse_share;     // Share of the diffuse light that does not pass through the surface, 0 to 1.
    vec2 oren_nayar;         // A and B of the diffuse reflection; (1, 0): ideally diffuse. See include/brdf.glsl.
    vec2 unused;
};

#include "end.glsl"
#endif
