// The surface that the G-buffer keeps at a pixel. Its ports are albedo, normal, orm and specular; gbuffer/gbuffer.frag says
// what they hold.
#ifndef WEFT_GBUFFER_SURFACE
#define WEFT_GBUFFER_SURFACE
#include "brdf.glsl"
#include "octahedral.glsl"

uniform sampler2D albedo;
uniform sampler2D normal;
uniform sampler2D orm;
uniform sampler2D specular;

// `material` is what orm holds there.
Surface gbuffer_surface(ivec2 pixel, vec3 material) {
    const vec3 base_root = texelFetch(albedo, pixel, 0).rgb;
    const vec4 coat = texelFetch(specular, pixel, 0);
    return make_surface(octahedral_decode(texelFetch(normal, pixel, 0).xy), base_root * base_root, material.b,
                        material.g, coat.rgb * coat.rgb, coat.a);
}
#endif
