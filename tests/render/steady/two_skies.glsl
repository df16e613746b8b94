// Two branches of very different length. Without Weft's workaround (docs/shaders.md, "Branches on values that
// change"), llvmpipe would compile a uniform in the condition as a constant, so only one branch would remain.
#include "sky.glsl"

vec4 two_skies(bool plain, vec2 at) {
    const vec3 direction = normalize(vec3(at, 1.0));
    if (plain) return vec4(gradient_radiance(direction), 1.0);
    return vec4(environment_radiance(direction, 0.1), 1.0);
}
