// Fills images with pseudo-random numbers from 0 to 1, which the test computes too.
#version 460
layout(local_size_x = 8, local_size_y = 8) in;
layout(r32f) writeonly uniform image2D a, b, c, d, e, f;
layout(push_constant) uniform Params { uint frameIndex; } params;

void main() {
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, imageSize(a)))) return;
    uint x = uint(at.x) * 747796405u + uint(at.y) * 2891336453u + params.frameIndex * 277803737u;
    x = (x >> 15 ^ x) * 2246822519u;
    x = (x >> 13 ^ x) * 3266489917u;
    const vec4 value = vec4(float((x >> 16 ^ x) >> 8) / 16777216.0);
    imageStore(a, at, value);
    imageStore(b, at, value);
    imageStore(c, at, value);
    imageStore(d, at, value);
    imageStore(e, at, value);
    imageStore(f, at, value);
}
