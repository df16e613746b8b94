// Writes the buffer `probeMap`, which probe_map.glsl describes, from the imports with the places of the probes.
#version 460
#include "probe_map.glsl"

layout(local_size_x = 64) in;

layout(std430) readonly buffer Grid { ProbeGrid items[]; } probeGrid;
layout(std430) readonly buffer Points { ProbePoint items[]; } probePoints;
layout(std430) readonly buffer Cells { ProbeCell items[]; } probeCells;
layout(std430) writeonly buffer Map { uvec4 items[]; } probeMap;

void write_grid(ProbeGrid grid) {
    probeMap.items[0] = uvec4(floatBitsToUint(grid.origin), floatBitsToUint(grid.spacing_m));
    probeMap.items[1] = uvec4(grid.levels, grid.slots, grid.probes, floatBitsToUint(grid.half_yaw_tangent));
    probeMap.items[2] = grid.strides[0];
    probeMap.items[3] = grid.strides[1];
}

void write_cell(uint first, ProbeCell cell) {
    probeMap.items[first] = uvec4(uvec3(cell.at), cell.level);
    for (uint i = 0u; i < 2u; ++i)
        probeMap.items[first + 1u + i] = uvec4(cell.corners[4u * i], cell.corners[4u * i + 1u],
                                               cell.corners[4u * i + 2u], cell.corners[4u * i + 3u]);
    probeMap.items[first + 3u] = uvec4(cell.neighbours, 0u, 0u, 0u);
}

void main() {
    const uint me = gl_GlobalInvocationID.x;
    const ProbeGrid grid = probeGrid.items[0];
    if (me == 0u) write_grid(grid);
    if (me < max(grid.probes, 1u)) {
        const ProbePoint point = probePoints.items[me];
        probeMap.items[kProbeGridItems + me] = uvec4(floatBitsToUint(point.position), floatBitsToUint(point.spacing_m));
    }
    if (me < grid.slots) write_cell(first_cell_item(grid.probes) + kProbeCellItems * me, probeCells.items[me]);
}
