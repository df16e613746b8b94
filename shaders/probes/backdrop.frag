// Writes a dim picture of the scene, and its depth, as the background of the spheres at the probes.
#version 460
#include "srgb.glsl"

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;

uniform sampler2D picture, surfaces;

layout(push_constant) uniform Params { vec2 pictureUv, surfacesUv; } params;

void main() {
    const vec3 light = filmic(textureLod(picture, uv * params.pictureUv, 0.0).rgb);
    const float grey = dot(light, vec3(0.2126, 0.7152, 0.0722));
    color = vec4(srgb_encode(0.6 * mix(vec3(grey), light, 0.4)), 1.0);
    gl_FragDepth = textureLod(surfaces, uv * params.surfacesUv, 0.0).r;
}
