#version 460
#include "area.glsl"
#include "frame_set.glsl"
#include "shape/poison.glsl"
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;
uniform sampler2D normal, depth;
layout(push_constant) uniform Params { vec2 normalUv, normalUvMost, normalSize; float time; } params;

// Also reads neighbours outside of the area, where area_uv() clamps.
void main() {
    const vec2 texel = 1.5 / params.normalSize;
    vec4 sum = vec4(0);
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x)
            sum += textureLod(normal, area_uv(uv + vec2(x, y) * texel, params.normalUv, params.normalUvMost), 0.0);
    const float z = texelFetch(depth, ivec2(gl_FragCoord.xy), 0).r;
    color = poisoned(sum / 9.0 + vec4(z, uv, view.viewport_px.x / 1024.0), params.time);
}
