// Measures arithmetic for `weft bench frame`: 8,192 operations per invocation. Each of the 8 components of `a` and `b`
// is a chain of 512 multiplications and 512 additions. The chains are independent, so their operations can overlap.
#version 460

layout(local_size_x = 64) in;

layout(std430) writeonly buffer Sums { float items[]; } sums;

void main() {
    const uint i = gl_GlobalInvocationID.x;
    const vec4 factor = vec4(0.999, 0.998, 0.997, 0.996);
    const vec4 summand = vec4(float(i & 255u) * 1e-6);
    vec4 a = vec4(0.1, 0.2, 0.3, 0.4), b = vec4(0.5, 0.6, 0.7, 0.8);
    for (int round = 0; round < 512; ++round) {
        a = a * factor + summand;
        b = b * factor + summand;
    }
    if (i < uint(sums.items.length())) sums.items[i] = dot(a, vec4(1.0)) + dot(b, vec4(1.0));
}
