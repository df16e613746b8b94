// Adds the light that the lens scatters. The pass uses alpha blending: the share `strength` of the picture is replaced
// by the blurred picture, and the share 1 − strength remains.
#version 460
#include "tent.glsl"

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 hdr;

uniform sampler2D bloom;

layout(push_constant) uniform Params { float strength; } params;

void main() { hdr = vec4(tent(bloom, uv), params.strength); }
