// Draws the shadow map of a lamp: only depth is written. Masked surfaces have holes, which let light through. Surfaces
// that emit light cast no shadow: they are the bulbs and the panes around lamps.
#version 460
#include "material_set.glsl"
#include "surface_fragment.glsl"

layout(constant_id = 0) const bool MASKED = false;

void main() {
    if (any(greaterThan(material.emissive, vec3(0.0)))) discard;
    if (MASKED && base_color().a < material.alpha_cutoff) discard;
}
