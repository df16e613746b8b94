#version 460
#include "frame_set.glsl"
#include "shared/bounds.glsl"
#include "shared/draw_command.glsl"
layout(local_size_x = 64) in;
readonly buffer Commands { DrawCommand items[]; } opaqueCommands;
readonly buffer Boxes { Bounds items[]; } bounds;
writeonly buffer Kept { DrawCommand items[]; } kept;
layout(push_constant) uniform Params { uint opaqueDraws; uint culls; } params;

// A box is outside the frustum if all its corners are beyond the same plane. The far plane is infinitely far.
bool is_outside(Bounds box) {
    bool left = true, right = true, top = true, bottom = true, near = true;
    for (int i = 0; i < 8; ++i) {
        const vec3 corner = mix(box.least, box.most, vec3(i & 1, i >> 1 & 1, i >> 2));
        const vec4 at = view.view_projection * vec4(corner, 1.0);
        left = left && at.x < -at.w;
        right = right && at.x > at.w;
        top = top && at.y < -at.w;
        bottom = bottom && at.y > at.w;
        near = near && at.z > at.w;
    }
    return left || right || top || bottom || near;
}

void main() {
    const uint i = gl_GlobalInvocationID.x;
    if (i >= params.opaqueDraws) return;
    DrawCommand command = opaqueCommands.items[i];
    if (params.culls != 0u && is_outside(bounds.items[command.first_instance])) command.instance_count = 0;
    kept.items[i] = command;
}
