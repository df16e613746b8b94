// Draws the shadow map: only depth is written. Masked surfaces have holes, which let sunlight through.
#version 460
#include "material_set.glsl"
#include "surface_fragment.glsl"

layout(constant_id = 0) const bool MASKED = false;

void main() {
    if (MASKED && base_color().a < material.alpha_cutoff) discard;
}
