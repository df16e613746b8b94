// Computes light shafts: for each pixel, it adds up the light on the line from the pixel to the sun's position in the
// picture. Source: Mitchell 2007, "Volumetric Light Scattering as a Post-Process", GPU Gems 3.
#version 460
#include "half_float.glsl"
#include "land.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D scene;
layout(rgba16f) writeonly uniform image2D shafts;

void main() {
    const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy), size = imageSize(shafts);
    if (any(greaterThanEqual(pixel, size))) return;
    const vec3 sun = to_sun();
    const vec2 on_screen = vec2(sun.x, -sun.y) / sun.z * kFocal + vec2(0.0, 0.10);
    const vec2 sun_uv = on_screen * vec2(float(size.y) / float(size.x), 1.0) * 0.5 + 0.5;
    const vec2 uv = (vec2(pixel) + 0.5) / vec2(size);
    vec3 sum = vec3(0.0);
    float weight = 1.0, weights = 0.0;
    for (int i = 0; i < 40; ++i, weight *= 0.965) {
        const vec4 seen = textureLod(scene, mix(uv, sun_uv, (float(i) + 0.5) / 40.0), 0.0);
        sum += min(seen.rgb, vec3(6.0)) * seen.a * weight;
        weights += weight;
    }
    const float near_sun = exp(-2.2 * length((uv - sun_uv) * vec2(float(size.x) / float(size.y), 1.0)));
    imageStore(shafts, pixel, vec4(nearest_half(sum / weights * near_sun), 1.0));
}
