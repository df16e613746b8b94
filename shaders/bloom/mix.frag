// Mixes the picture with a blurred picture, which is the light that the lens scatters. The pass uses alpha blending:
// the result is strength × blurred picture + (1 − strength) × picture.
#version 460
#include "tent.glsl"

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 hdr;

uniform sampler2D bloom;

layout(push_constant) uniform Params { float strength; } params;

void main() { hdr = vec4(tent(bloom, uv), params.strength); }
