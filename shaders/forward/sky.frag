// Draws the sky into all pixels, before the surfaces are drawn. Output: scene-linear Rec.709, cd/m² × preExposure.
#version 460
#include "frame_set.glsl"
#include "half_float.glsl"
#include "sky.glsl"

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 hdr;

void main() {
    const vec3 color = sky_radiance(ray_direction(uv)) * frame.pre_exposure;
    hdr = vec4(nearest_half(min(color, vec3(65000.0))), 1.0);
}
