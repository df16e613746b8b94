#version 460
#include "frame_set.glsl"
#include "poison.glsl"
layout(location = 0) in vec3 place;
layout(location = 0) out vec4 color;
layout(push_constant) uniform Params { float time; } params;

void main() { color = poisoned(vec4(fract(place), gl_FragCoord.x * view.inverse_viewport.x), params.time); }
