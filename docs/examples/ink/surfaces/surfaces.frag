// Writes the normal of the surface, and the brightness that determines how densely the pen hatches the surface.
#version 460
#include "frame_set.glsl"
#include "material_set.glsl"
#include "octahedral.glsl"

layout(constant_id = 0) const bool MASKED = false;

layout(location = 0) in vec3 world_normal;
layout(location = 1) in vec2 surface_uv;

layout(location = 0) out vec2 normal;  // The unit normal in world space, in octahedral encoding.
layout(location = 1) out vec4 tone;    // Channel r: brightness from 0 (black) to 1 (white).

const vec3 kLamp = vec3(0.48, 0.80, 0.36);

void main() {
    const vec4 base =
        texture(base_color_texture, transformed(material.base_color_uv, surface_uv)) * material.base_color;
    if (MASKED && base.a < material.alpha_cutoff) discard;
    const vec3 n = normalize(world_normal) * (gl_FrontFacing ? 1.0 : -1.0);
    const float light = 0.25 + 0.75 * clamp(dot(n, kLamp) * 0.6 + 0.4, 0.0, 1.0);
    const float luminance = dot(base.rgb, vec3(0.2126, 0.7152, 0.0722));
    normal = octahedral_encode(n);
    tone = vec4(sqrt(luminance) * light);
}
