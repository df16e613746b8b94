// Writes the G-buffer: the data about the nearest surface that lighting needs. Emission is written directly
// to hdr; lighting adds to it in place.
#version 460
#include "frame_set.glsl"
#include "material_set.glsl"
#include "octahedral.glsl"
#include "surface_fragment.glsl"

layout(constant_id = 0) const bool MASKED = false;

layout(location = 5) in vec4 clip_now;
layout(location = 6) in vec4 clip_before;

layout(location = 0) out vec4 albedo;    // rgb: √ base colour; drivers decode sRGB differently, but square roots are exact
layout(location = 1) out vec2 normal;    // octahedral, world space
layout(location = 2) out vec4 orm;       // occlusion, perceptual roughness, metalness
layout(location = 3) out vec4 specular;  // rgb: √F0 of the dielectric, a: specularFactor
layout(location = 4) out vec2 velocity;  // uv now − uv in the previous frame
layout(location = 5) out vec4 hdr;       // emission × preExposure

void main() {
    const vec4 base = base_color();
    if (MASKED && base.a < material.alpha_cutoff) discard;
    albedo = vec4(sqrt(base.rgb), 1.0);
    normal = octahedral_encode(shading_normal());
    orm = vec4(occlusion_roughness_metalness(), 1.0);
    specular = vec4(sqrt(material.dielectric_f0), material.specular);
    velocity = (clip_now.xy / clip_now.w - clip_before.xy / clip_before.w) * 0.5;
    hdr = vec4(min(emission() * frame.pre_exposure, vec3(65000.0)), 1.0);
}
