// Upsamples a coarse mip with a tent filter of 3×3 bilinear taps, so that the texels of the mip are not visible as
// squares.

vec3 tent(sampler2D src, vec2 uv) {
    const vec2 texel = 1.0 / vec2(textureSize(src, 0));
    vec3 sum = vec3(0.0);
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x)
            sum += textureLod(src, uv + vec2(x, y) * texel, 0.0).rgb * float((2 - abs(x)) * (2 - abs(y)));
    return sum / 16.0;
}
