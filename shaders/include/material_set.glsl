// Descriptor set 2: a material and its textures, as in glTF 2.0, KHR_materials_specular and KHR_materials_anisotropy.
#ifndef WEFT_MATERIAL_SET
#define WEFT_MATERIAL_SET
#include "shared/material.glsl"

layout(set = 2, binding = 0, std140) uniform MaterialBlock { Material material; };
layout(set = 2, binding = 1) uniform sampler2D base_color_texture;          // Texels are sRGB-encoded.
layout(set = 2, binding = 2) uniform sampler2D metallic_roughness_texture;  // Channel g: roughness, b: metalness.
layout(set = 2, binding = 3) uniform sampler2D normal_texture;
layout(set = 2, binding = 4) uniform sampler2D occlusion_texture;           // Channel r: occlusion.
layout(set = 2, binding = 5) uniform sampler2D emissive_texture;            // Texels are sRGB-encoded.
layout(set = 2, binding = 6) uniform sampler2D anisotropy_texture;  // Channels rg: direction of the grain, b: strength.

vec2 transformed(TextureTransform transform, vec2 uv) {
    const vec3 homogeneous = vec3(uv, 1.0);
    return vec2(dot(transform.row0.xyz, homogeneous), dot(transform.row1.xyz, homogeneous));
}
#endif
