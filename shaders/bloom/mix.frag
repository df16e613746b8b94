// The light that the lens scatters, for a pass with alpha blending: the picture keeps 1 − strength of its
// light.
#version 460
#include "tent.glsl"

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 hdr;

uniform sampler2D bloom;

layout(push_constant) uniform Params { float strength; } params;

void main() { hdr = vec4(tent(bloom, uv), params.strength); }
