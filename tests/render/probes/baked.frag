#version 460
// Reads all images of the bake, so that none of its passes is removed. Without probes, no pass writes them.
layout(location = 0) in vec2 uv;
layout(constant_id = 0) const bool HAS_albedo = false;
layout(constant_id = 1) const bool HAS_normal = false;
layout(constant_id = 2) const bool HAS_distance = false;
layout(constant_id = 3) const bool HAS_emission = false;
layout(constant_id = 4) const bool HAS_moments = false;
uniform sampler2DArray albedo, normal, distance, emission, moments;
out vec4 backbuffer;

void main() {
    const vec3 at = vec3(uv, 0.0);
    backbuffer = vec4(0.0);
    if (HAS_albedo) backbuffer += texture(albedo, at);
    if (HAS_normal) backbuffer += texture(normal, at);
    if (HAS_distance) backbuffer += texture(distance, at);
    if (HAS_emission) backbuffer += texture(emission, at);
    if (HAS_moments) backbuffer += texture(moments, at);
}
