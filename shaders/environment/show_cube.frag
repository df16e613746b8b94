// Debug view of a cube map: its mips below each other, each as a row of six faces in the order +x −x +y −y +z −z. The
// mean luminance of the smallest mip is shown as a medium grey.
#version 460
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;

uniform samplerCube shown;

layout(push_constant) uniform Params { vec2 colorSize; } params;

#include "cube_texels.glsl"

void main() {
    const int mips = textureQueryLevels(shown);
    const float side = min(params.colorSize.x / 6.0, params.colorSize.y / float(mips));
    const vec2 at = uv * params.colorSize / side;
    color = vec4(0.0, 0.0, 0.0, 1.0);
    if (at.x >= 6.0 || at.y >= float(mips)) return;
    vec3 mean = vec3(0.0);
    for (uint face = 0u; face < 6u; ++face)
        mean += textureLod(shown, face_direction(face, vec2(0.0)), float(mips - 1)).rgb / 6.0;
    const vec3 direction = face_direction(uint(at.x), fract(at) * 2.0 - 1.0);
    const float middle = max(dot(mean, vec3(0.2126, 0.7152, 0.0722)), 1e-6);
    const vec3 light = textureLod(shown, direction, floor(at.y)).rgb / middle;
    color.rgb = pow(light / (1.0 + light), vec3(1.0 / 2.2));
}
