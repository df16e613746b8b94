#version 460
#include "frame_set.glsl"
#include "lamp_shadow.glsl"
#include "octahedral.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D depth;
uniform sampler2D normal;
layout(std430) readonly buffer Lights { Light items[]; } lights;
layout(r32f) writeonly uniform image2D seen;

void main() {
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy), size = textureSize(depth, 0);
    if (any(greaterThanEqual(at, imageSize(seen)))) return;
    const ivec2 pixel = ivec2(at.x, at.y % size.y);
    const uint lamp = frame.directional_count + uint(at.y / size.y);
    const Light light = lights.items[min(lamp, frame.light_count - 1u)];
    const float z = max(texelFetch(depth, pixel, 0).r, 1e-6);
    const vec3 position = world_position((vec2(pixel) + 0.5) / vec2(size), z);
    const vec3 n = octahedral_decode(texelFetch(normal, pixel, 0).xy);
    const float share = lamp >= frame.light_count || light.shadow < kFirstLampMap ? -1.0 : lamp_visibility(light, position, n);
    imageStore(seen, at, vec4(share));
}
