// Writes the nearest transparent surface of each pixel, for the reflections. Output ssrGlass: xy: normal in octahedral
// encoding; z: roughness.
#version 460
#include "frame_set.glsl"
#include "material_set.glsl"
#include "octahedral.glsl"
#include "ripples.glsl"
#include "surface_fragment.glsl"

layout(location = 0) out vec4 ssrGlass;

void main() {
    const vec3 n = rippled_normal();
    const float roughness = roughness_of_pixel(occlusion_roughness_metalness().g, dFdx(n), dFdy(n));
    if (base_color().a <= 0.0) discard;  // After the derivatives, which are undefined after a discard.
    ssrGlass = vec4(octahedral_encode(n), roughness, 1.0);
}
