// For debug views: shows a number for each tile as a colour and in digits, with a key of the colours in a corner.
// Requires debug_colors.glsl, debug_digits.glsl and the image `shown`, which is the image tileFacts of facts.comp.

const float kMost = 128.0;  // Upper end of the colour scale, which is logarithmic.

// Returns the colour of a number: grey for 0, otherwise a heat colour. Pixels of the sky are black. Darker lines show
// where surfaces bend or end: there, the alpha of the image (how much the surface faces the eye) changes.
vec3 number_color(float number, ivec2 pixel) {
    const ivec2 last = textureSize(shown, 0) - 1;
    const float facing = texelFetch(shown, pixel, 0).a;
    if (facing <= 0.0) return vec3(0.0);
    const float right = texelFetch(shown, min(pixel + ivec2(1, 0), last), 0).a;
    const float below = texelFetch(shown, min(pixel + ivec2(0, 1), last), 0).a;
    const float line = smoothstep(0.02, 0.2, max(abs(right - facing), abs(below - facing)));
    const float scaled = log2(1.0 + min(number, kMost)) / log2(1.0 + kMost);
    return (number > 0.0 ? heat_color(scaled) : vec3(0.12)) * (1.0 - 0.5 * line);
}

// Draws the number into the middle of the tile, on a darkened rectangle, because the background may have any colour.
vec3 with_digits(vec3 ground, uint number, ivec2 pixel) {
    const ivec2 size = ivec2(4 * digits_of(number) - 1, 5), at = (pixel & 15) - (15 - size) / 2;
    if (number == 0u || any(lessThan(at, ivec2(-1))) || any(greaterThan(at, size))) return ground;
    return is_number(number, at) ? vec3(1.0) : ground * 0.35;
}

// Draws the scale of colours into the lower left corner, with the numbers 1, 4, 16 and 64 above it.
vec3 with_key(vec3 color, ivec2 pixel, ivec2 size) {
    const ivec2 at = pixel - ivec2(8, size.y - 30);
    const ivec2 strip = ivec2(180, 22);
    if (any(lessThan(at, ivec2(-4))) || any(greaterThan(at, strip + 4))) return color;
    const float scale = log2(1.0 + kMost) / float(strip.x);
    for (uint number = 1u; number <= uint(kMost); number *= 4u) {
        const int tick = int(log2(1.0 + float(number)) / scale);
        if (is_number(number, at - ivec2(tick - 2, 0))) return vec3(1.0);
        if (at.x == tick && at.y >= 6 && at.y < 9) return vec3(1.0);
    }
    const bool bar = at.y >= 9 && at.y < strip.y && at.x >= 0 && at.x < strip.x;
    return bar ? heat_color(float(at.x) / float(strip.x)) : vec3(0.0);
}
