// Reads the surface at a pixel from the G-buffer. Ports: albedo, normal, orm and specular; gbuffer/gbuffer.frag
// describes their contents.
#ifndef WEFT_GBUFFER_SURFACE
#define WEFT_GBUFFER_SURFACE
#include "brdf.glsl"
#include "octahedral.glsl"

uniform sampler2D albedo;
uniform sampler2D normal;
uniform sampler2D orm;
uniform sampler2D specular;

// Returns the surface at the pixel. `material` must be the texel of `orm` at this pixel.
Surface gbuffer_surface(ivec2 pixel, vec3 material) {
    const vec3 base_root = texelFetch(albedo, pixel, 0).rgb;
    const vec4 coat = texelFetch(specular, pixel, 0);
    return make_surface(octahedral_decode(texelFetch(normal, pixel, 0).xy), base_root * base_root, material.b,
                        material.g, coat.rgb * coat.rgb, coat.a);
}
#endif
