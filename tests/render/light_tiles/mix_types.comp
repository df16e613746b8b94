// Changes some point and spot lights to capsule and rectangle lights. Some lights lose their range limit (range_m = 0).
// Some spot lights get a cone whose half-angle is more than 90°.
#version 460
#include "frame_set.glsl"
#include "shared/light.glsl"

layout(local_size_x = 64) in;

readonly buffer Uploaded { Light items[]; } uploaded;
writeonly buffer Lights { Light items[]; } lights;

void main() {
    const uint i = gl_GlobalInvocationID.x;
    if (i >= uint(lights.items.length())) return;
    Light light = uploaded.items[i];
    if (i >= frame.directional_count) {
        if (i % 5u == 1u) {
            light.type = kLightCapsule;
            light.half_size_m = vec2(light.range_m * 0.7, light.range_m * 0.01);
        }
        if (i % 5u == 2u) {
            light.type = kLightRectangle;
            light.half_size_m = light.range_m * vec2(0.5, 0.2);
        }
        if (light.type == kLightSpot && i % 29u == 0u) light.cone_offset = 0.3 * light.cone_scale;
        if (i % 97u == 0u) light.range_m = 0.0;
    }
    lights.items[i] = light;
}
