#version 460
#include "frame_set.glsl"
layout(local_size_x = 4) in;
layout(push_constant) uniform Params { float gain; float lift; } params;
layout(rgba32f) writeonly uniform image2D dome;

void main() {
    const vec3 colors[4] = {frame.sky_zenith, frame.sky_horizon, frame.sky_ground, vec3(0)};
    const vec3 color = params.gain * colors[gl_GlobalInvocationID.x] + params.lift;
    imageStore(dome, ivec2(gl_GlobalInvocationID.xy), vec4(color, 1));
}
