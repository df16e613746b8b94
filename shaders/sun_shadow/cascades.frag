// Debug view of the sun's shadow maps. The image `shown` is the resource `depth`; positions are computed from
// it. The colour shows which map each point uses: orange is the nearest map to the eye, then green, blue,
// violet. The chequered pattern shows the size of the map's texels. Where two maps are blended, the colours
// are blended, too. Surfaces that face away from the sun are dark.
#version 460
#include "frame_set.glsl"

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;

uniform sampler2D shown;

const vec3 kTints[kMostSunCascades] =
    vec3[](vec3(1.0, 0.6, 0.3), vec3(0.4, 0.85, 0.45), vec3(0.35, 0.65, 1.0), vec3(0.8, 0.45, 0.95));

// Returns the colour of map i at this position. Neighbouring texels of the map have different brightness.
vec3 texels(uint i, vec3 position) {
    const mat4 to_map = sun.cascades[i].world_to_map;
    const float side_m = 1.0 / length(vec3(to_map[0][0], to_map[1][0], to_map[2][0]));
    const ivec2 texel = ivec2(floor((to_map * vec4(position, 1.0)).xy * side_m / sun.cascades[i].texel_m));
    return kTints[i] * (((texel.x + texel.y) & 1) == 0 ? 1.0 : 0.75);
}

void main() {
    const float z = textureLod(shown, uv, 0.0).r;
    color = vec4(0.0, 0.0, 0.0, 1.0);
    const vec3 position = world_position(uv, max(z, 1e-6));
    const vec3 normal = normalize(cross(dFdy(position), dFdx(position)));
    if (z <= 0.0 || sun.count == 0u) return;
    const float view_distance = distance(position, view.eye);
    uint i = 0u;
    while (i + 1u < sun.count && view_distance > sun.cascades[i].end_m) ++i;
    const float past = view_distance / sun.cascades[i].end_m - (1.0 - kSunBlend);
    vec3 tint = texels(i, position);
    if (past > 0.0 && i + 1u < sun.count) tint = mix(tint, texels(i + 1u, position), past / kSunBlend);
    color.rgb = tint * (0.35 + 0.65 * max(0.0, dot(normal, sun.to_sun)));
}
