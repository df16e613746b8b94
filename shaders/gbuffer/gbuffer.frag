// Writes the G-buffer: properties of the nearest surface in each pixel, which lighting needs later. Light that the
// surface emits is written directly to hdr, and the lighting pass adds the reflected light to it.
#version 460
#include "frame_set.glsl"
#include "material_set.glsl"
#include "octahedral.glsl"
#include "surface_fragment.glsl"

layout(constant_id = 0) const bool MASKED = false;

layout(location = 5) in vec4 clip_now;
layout(location = 6) in vec4 clip_before;

layout(location = 0) out vec4 albedo;    // √ of the base colour; not sRGB, because drivers decode sRGB differently.
layout(location = 1) out vec2 normal;    // Shading normal in world space, in octahedral encoding.
layout(location = 2) out vec4 orm;       // r: occlusion, g: perceptual roughness, b: metalness.
layout(location = 3) out vec4 specular;  // rgb: √F0 of the dielectric coat, a: specularFactor of the material.
layout(location = 4) out vec2 velocity;  // Position in the picture (uv) minus the position in the previous frame.
layout(location = 5) out vec4 hdr;       // Light that the surface emits × preExposure.

void main() {
    const vec4 base = base_color();
    // The reflections of the screen follow the clear coat. A forward pass draws coated surfaces again, with both layers.
    const bool coated = material.clearcoat > 0.0;
    const vec3 n = coated ? mesh_normal() : shading_normal(), dx = dFdx(n), dy = dFdy(n);  // Derivatives are undefined after a discard.
    if (MASKED && base.a < material.alpha_cutoff) discard;
    orm = vec4(occlusion_roughness_metalness(), 1.0);
    albedo = vec4(sqrt(reflected_color(base.rgb, orm.b)), 1.0);
    normal = octahedral_encode(n);
    orm.g = roughness_of_pixel(coated ? material.clearcoat_roughness : orm.g, dx, dy);
    specular = vec4(sqrt(material.dielectric_f0), material.specular);
    velocity = (clip_now.xy / clip_now.w - clip_before.xy / clip_before.w) * 0.5;
    hdr = vec4(min(emission() * frame.pre_exposure, vec3(65000.0)), 1.0);
}
