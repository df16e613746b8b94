// Two ways that differ so much in length that llvmpipe thinks it worth to compile the one that is taken by itself.
#include "sky.glsl"

vec4 two_skies(bool plain, vec2 at) {
    const vec3 direction = normalize(vec3(at, 1.0));
    if (plain) return vec4(gradient_radiance(direction), 1.0);
    return vec4(environment_radiance(direction, 0.1), 1.0);
}
