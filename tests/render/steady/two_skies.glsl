// Returns the radiance of a sky, with one of two branches of very different length. If the condition depends on a
// uniform, llvmpipe compiles the value of this uniform as a constant. Weft has a workaround against this
// (docs/shaders.md, "Branches on values that change").
#include "sky.glsl"

vec4 two_skies(bool plain, vec2 at) {
    const vec3 direction = normalize(vec3(at, 1.0));
    if (plain) return vec4(gradient_radiance(direction), 1.0);
    return vec4(environment_radiance(direction, 0.1), 1.0);
}
