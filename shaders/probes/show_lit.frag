// Debug view of the probe that was lit last: the light that it sees, as two rows of three faces, +x −x +y −y +z −z.
#version 460
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;

uniform sampler2DArray shown;

layout(push_constant) uniform Params { vec2 colorSize; } params;

void main() {
    const float side = min(params.colorSize.x / 3.0, params.colorSize.y / 2.0);
    const vec2 at = uv * params.colorSize / side;
    color = vec4(0.0, 0.0, 0.0, 1.0);
    if (at.x >= 3.0 || at.y >= 2.0) return;
    const int size = textureSize(shown, 0).x;
    vec3 mean = vec3(0.0);
    for (int i = 0; i < 384; ++i)
        mean += texelFetch(shown, ivec3(ivec2(i % 8, i / 8 % 8) * size / 8, i / 64), 0).rgb / 384.0;
    const float middle = max(dot(mean, vec3(0.2126, 0.7152, 0.0722)), 1e-6);
    const ivec3 texel = ivec3(fract(at) * float(size), int(at.x) + 3 * int(at.y));
    const vec3 light = texelFetch(shown, texel, 0).rgb / middle;
    color.rgb = pow(light / (1.0 + light), vec3(1.0 / 2.2));
}
