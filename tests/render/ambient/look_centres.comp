// Looks up the ambient light in the directions of the 1,536 texels of a cube with 16 × 16 texels per face, for the
// roughnesses 0.2, 0.4, 0.6, 0.8 and 1. Each column is one direction: direction_of_centre() in centres_fixture.h.
#version 460
#include "ambient.glsl"

layout(local_size_x = 64) in;

layout(rgba32f) writeonly uniform image2D centres;

void main() {
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy), size = imageSize(centres);
    if (any(greaterThanEqual(at, size))) return;
    const int face = at.x / 256, axis = face / 2;
    vec3 n;
    n[axis] = face % 2 == 0 ? 1.0 : -1.0;
    n[(axis + 1) % 3] = (float(at.x % 16) * 2.0 + 1.0) / 16.0 - 1.0;
    n[(axis + 2) % 3] = (float(at.x / 16 % 16) * 2.0 + 1.0) / 16.0 - 1.0;
    n = normalize(n);
    imageStore(centres, at, vec4(mirrored_radiance(n, n, 0.2 * float(at.y + 1)), 1.0));
}
