// A material in set 2, without its six textures. Texture transforms are two rows: uv' = (row0·(u,v,1), …).
#ifndef WEFT_SHARED_MATERIAL
#define WEFT_SHARED_MATERIAL
#include "begin.glsl"

struct TextureTransform {
    vec4 row0;               // w: index of the transformed uv set, 0 or 1
    vec4 row1;
};

struct Material {
    vec4 base_color;
    vec3 emissive;           // cd/m²
    float alpha_cutoff;
    vec3 dielectric_f0;      // ((ior − 1)/(ior + 1))² · specularColor, at most 1
    float specular;          // specularFactor
    float metallic;
    float roughness;         // perceptual roughness
    float normal_scale;
    float occlusion_strength;
    TextureTransform base_color_uv;
    TextureTransform metallic_roughness_uv;
    TextureTransform normal_uv;
    TextureTransform occlusion_uv;
    TextureTransform emissive_uv;
    float emission_tint;     // 1: vertex colours multiply the emission too
    float anisotropy;        // strength, 0 to 1
    vec2 anisotropy_turn;    // cosine and sine of the rotation of the direction from the tangent
    TextureTransform anisotropy_uv;
    float anisotropy_textured;  // 1: the direction comes from a texture; 0: it is the tangent
    float reserved0;
    float reserved1;
    float reserved2;
};

#include "end.glsl"
#endif
