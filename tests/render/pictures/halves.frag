// Draws bright red in focus on the left half, and blue and green stripes at the distance right_m on the right half.
#version 460
#include "frame_set.glsl"
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 hdr;
layout(push_constant) uniform Params { float focus; float right_m; } params;
void main() {
    const bool left = uv.x < 0.5;
    const bool stripe = (int(gl_FragCoord.y) / 2) % 2 == 0;
    hdr = vec4(left ? vec3(100.0, 0.0, 0.0) : stripe ? vec3(0.0, 0.0, 2.0) : vec3(0.0, 1.0, 0.0), 1.0);
    gl_FragDepth = view.near_m / (left ? params.focus : params.right_m);
}
