// Draws small bright lamps at the distance lamp_m in front of a dim wall at the distance wall_m. With a very
// large wall_m, the wall stands for the sky.
#version 460
#include "frame_set.glsl"
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 hdr;
layout(push_constant) uniform Params { float lamp_m; float wall_m; } params;
void main() {
    const ivec2 cell = ivec2(gl_FragCoord.xy) / 32;
    // The lamps differ in size and in their position within a pixel.
    const vec2 center = vec2(cell * 32) + 16.0 + fract(vec2(cell) * vec2(0.37, 0.61) + vec2(cell.yx) * 0.23) * 2.0;
    const bool lamp = distance(gl_FragCoord.xy, center) < 0.8 + 0.6 * float((cell.x + cell.y) % 4);
    hdr = vec4(lamp ? vec3(400.0) : vec3(0.1), 1.0);
    gl_FragDepth = view.near_m / (lamp ? params.lamp_m : params.wall_m);
}
