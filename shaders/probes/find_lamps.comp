// Finds the lamps that a light probe sees, and writes them to the buffer `lamps` (probe_lamps.glsl). The lights are in
// groups of 32. Thread t tests the groups t, t + 64, t + 128 and so on.
#version 460
#include "frame_set.glsl"
#include "lamp_share.glsl"
#include "lights.glsl"
#include "probe_lamps.glsl"
#include "shared/probe_grid.glsl"

layout(local_size_x = 64) in;

layout(std430) readonly buffer SceneLights { Light items[]; } sceneLights;
layout(std430) readonly buffer ProbePoints { ProbePoint items[]; } probePoints;
layout(std430) writeonly buffer Lamps { uint items[]; } lamps;
layout(push_constant) uniform Params { int p; } params;  // The number of the probe.

void main() {
    const vec3 probe = probePoints.items[params.p].position;
    const uint count = min(frame.light_count, uint(sceneLights.items.length()));
    for (uint word = gl_GlobalInvocationID.x; 32u * word < count; word += 64u) {
        uint seen = 0u;
        const uint first = max(32u * word, frame.directional_count), end = min(32u * word + 32u, count);
        for (uint i = first; i < end; ++i) {
            const float share = lamp_share(sceneLights.items[i], probe);
            if (share <= 0.0) continue;
            seen |= 1u << (i & 31u);
            lamps.items[kLampWords + i] = floatBitsToUint(share);
        }
        lamps.items[word] = seen;
    }
}
