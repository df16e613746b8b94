// Depth of surfaces that hide the surfaces behind them: masked surfaces have holes.
#version 460
#include "material_set.glsl"
#include "surface_fragment.glsl"

layout(constant_id = 0) const bool MASKED = false;

void main() {
    if (MASKED && base_color().a < material.alpha_cutoff) discard;
}
