// Copies the places and the boxes of the reflection probes to one buffer, which include/reflection_probes.glsl describes.
#version 460
#include "shared/probe_grid.glsl"
#include "shared/reflection_box.glsl"

layout(local_size_x = 32) in;

readonly buffer ReflectionPoints { ProbePoint items[]; } reflectionPoints;
readonly buffer ReflectionBoxes { ReflectionBox items[]; } reflectionBoxes;
layout(std430) writeonly buffer ReflectionMap { vec4 items[]; } reflectionMap;

void main() {
    const uint probe = gl_GlobalInvocationID.x;
    if (probe >= uint(reflectionPoints.items.length())) return;
    const uint first = probe * kReflectionItems;
    reflectionMap.items[first] = vec4(reflectionPoints.items[probe].position, 1.0);
    for (uint i = 0u; i < 3u; ++i) reflectionMap.items[first + 1u + i] = reflectionBoxes.items[probe].to_box[i];
}
