// Reads the texels that one texel of a half-size picture needs: five overlapping boxes of 2×2 bilinear taps. The middle
// box has half of the total weight. Summed over all output pixels, every source texel has the same weight, so the
// brightness does not change.
// Source: Jimenez 2014, "Next Generation Post Processing in Call of Duty: Advanced Warfare".

struct Box {
    vec3 mean;
    float weight;
};

struct Boxes {
    Box middle;
    Box corners[4];
};

vec3 tap(sampler2D src, vec2 uv, vec2 texel, float x, float y) {
    return textureLod(src, uv + vec2(x, y) * texel, 0.0).rgb;
}

Boxes boxes_around(sampler2D src, vec2 uv) {
    const vec2 texel = 1.0 / vec2(textureSize(src, 0));
    vec3 ring[9];
    for (int i = 0; i < 9; ++i) ring[i] = tap(src, uv, texel, float(i % 3) * 2.0 - 2.0, float(i / 3) * 2.0 - 2.0);
    Boxes boxes;
    boxes.middle = Box((tap(src, uv, texel, -1.0, -1.0) + tap(src, uv, texel, 1.0, -1.0) +
                        tap(src, uv, texel, -1.0, 1.0) + tap(src, uv, texel, 1.0, 1.0)) * 0.25, 0.5);
    for (int i = 0; i < 4; ++i) {
        const int first = i % 2 + i / 2 * 3;
        boxes.corners[i] = Box((ring[first] + ring[first + 1] + ring[first + 3] + ring[first + 4]) * 0.25, 0.125);
    }
    return boxes;
}
