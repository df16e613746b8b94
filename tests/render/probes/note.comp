#version 460
#include "frame_set.glsl"
// Notes the number, the time and the jitter of the frame, the view of the previous frame, and the values of the previous
// frame.
layout(local_size_x = 8, local_size_y = 8) in;
uniform sampler2D before;
layout(rgba32f) writeonly uniform image2D noted;
layout(push_constant) uniform Params { float beforeValid; int frameIndex; float time; } params;

void main() {
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, imageSize(noted)))) return;
    vec4 value = vec4(0);
    if (at.y == 0) value = vec4(frame.frame_index, frame.time_s, frame.pre_exposure, frame.prev_pre_exposure);
    if (at.y == 1) value = view.view_projection[at.x % 4];
    if (at.y == 2) value = view.prev_view_projection[at.x % 4];
    if (at.y == 3) value = vec4(params.beforeValid, params.frameIndex, params.time, 1);
    if (at.y == 4 && params.beforeValid > 0.0) value = texelFetch(before, ivec2(at.x, 0), 0);
    imageStore(noted, at, value);
}
