// Normals of surfaces with ripples that move, such as water. Only fragment stages can use this file. It is separate from
// surface_fragment.glsl, because a pass whose shader reads the time can never rest.
#ifndef WEFT_RIPPLES
#define WEFT_RIPPLES
#include "frame_set.glsl"
#include "material_set.glsl"
#include "surface_fragment.glsl"

// Returns the slopes of the normal map at `uv`, along the tangent and along the bitangent.
vec2 slopes_at(vec2 uv) {
    const vec3 m = texture(normal_texture, uv, view.mip_bias).xyz * 2.0 - 1.0;
    return m.xy * material.normal_scale / max(m.z, 0.1);
}

// Returns the normal of the surface. If the material has ripples, the slopes of two layers of the normal map are added,
// and both layers move. The second layer is rotated by 90° and a little larger, so that the layers never look alike.
vec3 rippled_normal() {
    if (material.ripples == vec4(0.0)) return shading_normal();
    const float kSecondScale = 0.77;
    const vec2 uv = texture_uv(material.normal_uv);
    const vec2 second = kSecondScale * vec2(-uv.y, uv.x);
    const vec2 a = slopes_at(uv + fract(material.ripples.xy * frame.time_s));
    const vec2 b = slopes_at(second + fract(material.ripples.zw * frame.time_s));
    return world_normal_of(vec3(a + kSecondScale * vec2(-b.y, b.x), 1.0));
}
#endif
