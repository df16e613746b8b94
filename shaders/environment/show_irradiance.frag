// Debug view of the diffuse light of the surroundings: a panorama of the directions of the normal, and a sphere. The
// picture is scaled so that the mean luminance is a medium grey.
#version 460
#include "environment_cube.glsl"

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;

readonly buffer Shown { vec4 items[]; } shown;

layout(push_constant) uniform Params { vec2 colorSize; } params;

const float kPi = 3.14159265;

void main() {
    const vec2 at = uv * params.colorSize / min(params.colorSize.x / 3.0, params.colorSize.y);
    vec3 n;
    color = vec4(0.0, 0.0, 0.0, 1.0);
    if (at.y >= 1.0 || at.x >= 3.0) return;
    if (at.x < 2.0) {  // −z is in the middle of the panorama.
        const float azimuth = (at.x - 1.0) * kPi, polar = at.y * kPi;
        n = vec3(sin(polar) * sin(azimuth), cos(polar), -sin(polar) * cos(azimuth));
    } else {  // The side of the sphere that faces +z.
        const vec2 p = vec2(at.x - 2.5, 0.5 - at.y) * 2.1;
        if (dot(p, p) >= 1.0) return;
        n = vec3(p, sqrt(1.0 - dot(p, p)));
    }
    const float basis[9] = harmonic_basis(n);
    const int terms = min(shown.items.length(), 9);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < terms; ++i) sum += shown.items[i].rgb * basis[i];
    const vec3 light = max(sum, vec3(0.0)) / max(dot(shown.items[0].rgb, vec3(0.2126, 0.7152, 0.0722)), 1e-6);
    color.rgb = pow(light / (1.0 + light), vec3(1.0 / 2.2));
}
