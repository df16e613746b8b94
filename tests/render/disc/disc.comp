// Evaluates the reflection of disc lights. Each row of the pictures is a case: the roughness, the angle of the eye to the
// normal, and the angular radius. Each column is a direction of the light: see light_direction().
#version 460
#include "disc_light.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba32f) writeonly uniform image2D dst;

const float kRoughness[] = float[](0.05, 0.1, 0.2, 0.4, 0.6);
const float kEye_deg[] = float[](0.0, 40.0, 60.0, 75.0);
const float kRadius_deg[] = float[](0.27, 1.0, 2.0, 4.0);

// Returns the middle of the light: the mirrored direction of the eye, moved away from it in one of four directions. The
// steps are quarters of the width of the highlight.
vec3 light_direction(vec3 v, float width, int column) {
    const vec3 mirrored = vec3(-v.x, v.y, 0.0), along = vec3(v.y, v.x, 0.0);
    const float angle = float(column / 4) * 0.25 * width, turn = float(column % 4) * 0.5 * kPi + 0.2 * float(column / 4);
    return mirrored * cos(angle) + (along * cos(turn) + vec3(0.0, 0.0, 1.0) * sin(turn)) * sin(angle);
}

void main() {
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, imageSize(dst)))) return;
    const float roughness = kRoughness[at.y % 5], radius = radians(kRadius_deg[at.y / 20]);
    const float eye = radians(kEye_deg[at.y / 5 % 4]);
    const vec3 v = vec3(sin(eye), cos(eye), 0.0);
    const vec3 l = light_direction(v, length(vec2(radius, 2.0 * roughness * roughness)), at.x);
    Surface metal = make_surface(vec3(0.0, 1.0, 0.0), vec3(0.9, 0.5, 0.1), 1.0, roughness, vec3(0.0), 1.0);
    Surface stretched_alike = metal;  // An anisotropic surface with equal roughness in both directions.
    stretched_alike.anisotropic = true;
    stretched_alike.tangent = normalize(vec3(1.0, 0.0, 2.0));
    stretched_alike.bitangent = cross(metal.normal, stretched_alike.tangent);
    imageStore(dst, at, vec4(reflect_disc(metal, v, l, radius).rg, reflect_disc(stretched_alike, v, l, radius).r,
                             reflect_disc(metal, v, l, 1e-5).r / max(reflect_light(metal, v, l).r, 1e-30)));
}
