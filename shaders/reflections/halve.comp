// Blurs and halves one mip of the lit picture. Each texel is the mean of 4 × 4 texels with the weights 1 3 3 1 in both
// directions, from four linear samples.
#version 460
layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D src;
layout(rgba16f) writeonly uniform image2D dst;

void main() {
    const ivec2 texel = ivec2(gl_GlobalInvocationID.xy), size = imageSize(dst);
    if (any(greaterThanEqual(texel, size))) return;
    const vec2 uv = (vec2(texel) + 0.5) / vec2(size), apart = 0.75 / vec2(textureSize(src, 0));
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 4; ++i) {
        const vec2 corner = vec2(i & 1, i >> 1) * 2.0 - 1.0;
        sum += textureLod(src, uv + corner * apart, 0.0).rgb;
    }
    imageStore(dst, texel, vec4(0.25 * sum, 0.0));
}
