// Functions that mix integers. Integer arithmetic is exact, so any two correct plans of a graph give the same
// bytes. Each pass has its own seed, so that passes with the same inputs give different results.
layout(push_constant) uniform Params { uint seed; } params;

// Returns a 32-bit integer hash (M. Jarzynski, M. Olano, "Hash Functions for GPU Rendering", JCGT 2020).
uint scramble(uint v) {
    const uint state = v * 747796405u + 2891336453u;
    const uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return (word >> 22u) ^ word;
}

// Returns the texel of the first mip, combined with the texel of the last mip if there are several. So a
// wrong first or last mip changes the result of the pass.
uint fetch(usampler2D image, uvec2 at) {
    const int last = textureQueryLevels(image) - 1;
    const uint value = texelFetch(image, ivec2(at % uvec2(textureSize(image, 0))), 0).r;
    if (last == 0) return value;
    return scramble(value) + texelFetch(image, ivec2(at % uvec2(textureSize(image, last))), last).r;
}
