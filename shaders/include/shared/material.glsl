// A material as set 2 holds it, beside its six textures. Texture transforms are two rows: uv' = (row0·(u,v,1), …).
#ifndef WEFT_SHARED_MATERIAL
#define WEFT_SHARED_MATERIAL
#include "begin.glsl"

struct TextureTransform {
    vec4 row0;               // w: the uv set that is transformed, 0 or 1
    vec4 row1;
};

struct Material {
    vec4 base_color;
    vec3 emissive;           // cd/m²
    float alpha_cutoff;
    vec3 dielectric_f0;      // ((ior − 1)/(ior + 1))² · specularColor, at most 1
    float specular;          // specularFactor
    float metallic;
    float roughness;         // perceptual
    float normal_scale;
    float occlusion_strength;
    TextureTransform base_color_uv;
    TextureTransform metallic_roughness_uv;
    TextureTransform normal_uv;
    TextureTransform occlusion_uv;
    TextureTransform emissive_uv;
    float emission_tint;     // 1: vertex colours multiply the emission too
    float anisotropy;        // strength, 0 to 1
    vec2 anisotropy_turn;    // cosine and sine of the way that the direction is turned from the tangent
    TextureTransform anisotropy_uv;
    float anisotropy_textured;  // 1: a texture has directions; 0: there is only the tangent
    float reserved0;
    float reserved1;
    float reserved2;
};

#include "end.glsl"
#endif
