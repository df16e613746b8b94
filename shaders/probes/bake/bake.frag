// Writes the properties of the surfaces that a probe sees. graphs/modules/probe_bake.json describes the images.
#version 460
#include "material_set.glsl"
#include "octahedral.glsl"
#include "shared/probe_grid.glsl"
#include "surface_fragment.glsl"

layout(constant_id = 0) const bool MASKED = false;

layout(location = 5) in vec3 from_probe;

layout(location = 0) out vec4 probeAlbedo;
layout(location = 1) out vec2 probeNormal;
layout(location = 2) out float probeDistance;
layout(location = 3) out vec4 probeEmission;

void main() {
    const vec4 base = base_color();
    if (MASKED && base.a < material.alpha_cutoff) discard;
    // The back of a surface that is not two-sided is the inside of an object: no light leaves it.
    const bool inside = !gl_FrontFacing && material.two_sided == 0u;
    const float metalness = occlusion_roughness_metalness().b;
    probeAlbedo = vec4(sqrt(reflected_color(base.rgb, metalness)), metalness);
    probeNormal = octahedral_encode(shading_normal());
    probeDistance = length(from_probe) * (inside ? -1.0 : 1.0);
    probeEmission = vec4(inside ? vec3(0.0) : min(emission() * kProbeRadianceScale, vec3(65000.0)), 1.0);
}
