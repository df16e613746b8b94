#version 460
#include "area.glsl"
#include "shape/poison.glsl"
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;
uniform sampler2D now, marked, counted, before;
layout(push_constant) uniform Params {
    vec2 nowUv, nowUvMost, markedUv, markedUvMost, beforeUv, beforeUvMost, countedSize;
    float time, deltaTime;
} params;

void main() {
    vec4 sum = textureLod(now, area_uv(uv + 0.01, params.nowUv, params.nowUvMost), 0.0);
    sum += textureLod(marked, area_uv(uv - 0.01, params.markedUv, params.markedUvMost), 0.0);
    sum += texelFetch(counted, min(ivec2(gl_FragCoord.xy / 16.0), ivec2(params.countedSize) - 1), 0) / 64.0;
    const vec4 last = textureLod(before, area_uv(uv + 0.003, params.beforeUv, params.beforeUvMost), 0.0);
    color = poisoned(params.deltaTime > 0.0 ? mix(sum, last, 0.5) : sum, params.time);
}
