// Computes the height map of the land once, so that all rays can read it. The ridges are rough at the top and smooth in
// the valleys (Musgrave 1989, "The Synthesis and Rendering of Eroded Fractal Terrains"). A curved valley contains the
// water.
#version 460
#include "land.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(r32f) writeonly uniform image2D land;

float ridges(vec2 p) {
    float sum = 0.0, share = 0.5, above = 1.0;
    for (int i = 0; i < 9; ++i, share *= 0.5, p = finer(p)) {
        const float fold = 1.0 - abs(2.0 * noise(p) - 1.0);
        const float ridge = fold * fold * above;
        sum += ridge * share;
        above = clamp(ridge * 1.7, 0.0, 1.0);
    }
    return sum;
}

void main() {
    const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(land)))) return;
    const vec2 xz = kLandCorner + kLandSide * (vec2(pixel) + 0.5) / vec2(imageSize(land));
    const vec2 bent = xz + 0.55 * (vec2(soft_noise(xz * 0.7, 3), soft_noise(xz * 0.7 + 31.7, 3)) - 0.44);
    const float across = abs(bent.x - 0.9 * sin(bent.y * 0.42) - 0.1) - 0.16 * bent.y;
    const float shore = smoothstep(0.25, 3.0, across) + 0.8 * smoothstep(9.5, 13.0, bent.y);
    const float height = ridges(bent * 0.47 + vec2(6.6, 0.4)) * 2.7 * min(shore, 1.15) + 0.18 * smoothstep(0.1, 0.9, across);
    imageStore(land, pixel, vec4(min(height - 0.07, kHighest)));
}
