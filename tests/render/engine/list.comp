// Writes what the frame contains: the number of lights and of directional lights, the positions of the lights in the
// buffer, and the corners of the boxes of the first two instances.
#version 460
#include "frame_set.glsl"
#include "shared/bounds.glsl"
#include "shared/light.glsl"
layout(local_size_x = 8) in;
readonly buffer Lights { Light items[]; } lights;
readonly buffer Boxes { Bounds items[]; } bounds;
layout(rgba32f) writeonly uniform image2D seen;

void main() {
    const uint i = gl_GlobalInvocationID.x;
    vec4 value = vec4(frame.light_count, frame.directional_count, 0.0, 0.0);
    if (i > 0u && i <= min(frame.light_count, 4u)) value = vec4(lights.items[i - 1u].position, float(lights.items[i - 1u].type));
    const uint box = i - 5u;
    if (i >= 5u && box < uint(bounds.items.length())) value = vec4(bounds.items[box].least, bounds.items[box].most.x);
    for (int row = 0; row < imageSize(seen).y; ++row) imageStore(seen, ivec2(i, row), value);
}
