// Debug view of the sun's shadow maps. The image `shown` is the resource `depth`; positions are computed from it. The
// colour shows which map each point uses: orange is the map that covers the smallest area, then green, blue, violet.
// White: no map. The chequered pattern shows the size of the map's texels. Where two maps are blended, the colours are
// blended, too. Surfaces that face away from the sun are dark.
#version 460
#include "frame_set.glsl"

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;

uniform sampler2D shown;

const vec3 kTints[kMostSunCascades] =
    vec3[](vec3(1.0, 0.6, 0.3), vec3(0.4, 0.85, 0.45), vec3(0.35, 0.65, 1.0), vec3(0.8, 0.45, 0.95));

// Returns in xy the position in map i, in texels. w is the weight of map i, 0 to 1: near its edge, the map is blended
// with the next map.
vec4 place_in(uint i, vec3 position) {
    const mat4 to_map = sun.cascades[i].world_to_map;
    const vec2 side_m = 1.0 / vec2(length(vec3(to_map[0][0], to_map[1][0], to_map[2][0])),
                                   length(vec3(to_map[0][1], to_map[1][1], to_map[2][1])));
    const vec2 size = side_m / sun.cascades[i].texel_m, at = (to_map * vec4(position, 1.0)).xy * size;
    const vec2 inside = min(at, size - at) - 2.0;
    return vec4(at, 0.0, clamp(min(inside.x, inside.y) / kSunBlendTexels, 0.0, 1.0));
}

void main() {
    const float z = textureLod(shown, uv, 0.0).r;
    color = vec4(0.0, 0.0, 0.0, 1.0);
    const vec3 position = world_position(uv, max(z, 1e-6));
    const vec3 normal = normalize(cross(dFdy(position), dFdx(position)));
    if (z <= 0.0 || sun.count == 0u) return;
    vec3 tint = vec3(0.0);
    float rest = 1.0;
    for (uint i = 0u; i < sun.count; ++i) {
        const vec4 place = place_in(i, position);
        const ivec2 texel = ivec2(floor(place.xy));
        // Neighbouring texels of the map have different brightness.
        tint += rest * place.w * kTints[i] * (((texel.x + texel.y) & 1) == 0 ? 1.0 : 0.75);
        rest -= rest * place.w;
    }
    color.rgb = (tint + rest) * (0.35 + 0.65 * max(0.0, dot(normal, sun.to_sun)));
}
