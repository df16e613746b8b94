// Samples a picture between texels with the Catmull-Rom filter. The history is filtered again in every frame,
// so linear filtering would blur it more and more. The filter weights four texels per axis. A bilinear tap
// reads the two inner texels of an axis at once, and the corners are left out, so five taps are enough.
// Source: Jimenez 2016, "Filmic SMAA".

vec4 catmull_rom(sampler2D src, vec2 uv) {
    const vec2 size = vec2(textureSize(src, 0));
    const vec2 middle = floor(uv * size - 0.5) + 0.5, f = uv * size - middle;
    const vec2 w0 = f * (-0.5 + f * (1.0 - 0.5 * f)), w1 = 1.0 + f * f * (-2.5 + 1.5 * f);
    const vec2 w2 = f * (0.5 + f * (2.0 - 1.5 * f)), w3 = f * f * (-0.5 + 0.5 * f);
    const vec2 inner = w1 + w2;
    const vec2 low = (middle - 1.0) / size, mid = (middle + w2 / inner) / size, high = (middle + 2.0) / size;
    const vec4 sum = textureLod(src, mid, 0.0) * (inner.x * inner.y) +
                     textureLod(src, vec2(low.x, mid.y), 0.0) * (w0.x * inner.y) +
                     textureLod(src, vec2(high.x, mid.y), 0.0) * (w3.x * inner.y) +
                     textureLod(src, vec2(mid.x, low.y), 0.0) * (inner.x * w0.y) +
                     textureLod(src, vec2(mid.x, high.y), 0.0) * (inner.x * w3.y);
    return sum / (inner.x * inner.y + (w0.x + w3.x) * inner.y + inner.x * (w0.y + w3.y));
}
