#version 460
#include "shared/probe_grid.glsl"
// Shows the distance of the faces of the first 16 probes: one row for each probe, with its six faces side by side.
uniform sampler2DArray faceDepth;
readonly buffer ProbePoints { ProbePoint items[]; } probePoints;
readonly buffer ProbeCells { ProbeCell items[]; } probeCells;
readonly buffer ProbeGridBlock { ProbeGrid item; } probeGrid;
out vec4 backbuffer;

void main() {
    const ivec2 at = ivec2(gl_FragCoord.xy), tile = at / 16;
    backbuffer = vec4(0, 0, 0, 1);
    if (tile.x >= 6 || uint(tile.y) >= probeGrid.item.probes) return;
    const float depth = texelFetch(faceDepth, ivec3(at % 16, 6 * tile.y + tile.x), 0).r;
    backbuffer.rgb = vec3(depth > 0.0 ? exp2(-0.01 / depth) : 0.0);
    if (all(equal(at % 16, ivec2(0)))) backbuffer.rg = vec2(probePoints.items[tile.y].spacing_m, float(probeCells.items[0].level + 1u) / 255.0);
}
