#version 460
#include "shared/probe_grid.glsl"
// Finds each probe at the corners of the cells: a cell that shaders find by its key names the probes of this cell.
layout(local_size_x = 1) in;
readonly buffer ProbePoints { ProbePoint items[]; } probePoints;
readonly buffer ProbeCells { ProbeCell items[]; } probeCells;
readonly buffer ProbeGridBlock { ProbeGrid item; } probeGrid;
buffer Counts { uint items[]; } counts;

bool holds_probes(ProbeCell cell) {
    for (uint corner = 0u; corner < 8u; ++corner) {
        if (cell.corners[corner] == kNoProbe) continue;
        const ProbeGrid grid = probeGrid.item;
        const int stride = int(grid.strides[cell.level / 4u][cell.level % 4u]);
        const ivec3 at = cell.at + stride * ivec3(corner & 1u, corner >> 1u & 1u, corner >> 2u);
        const vec3 way = probePoints.items[cell.corners[corner]].position - (grid.origin + vec3(at) * grid.spacing_m);
        if (length(way) > 0.45 * grid.spacing_m * float(stride) + 1e-4) return false;
    }
    return true;
}

void main() {
    uint cells = 0u, right = 0u;
    for (uint i = 0u; i < probeGrid.item.slots; ++i) {
        const ProbeCell cell = probeCells.items[i];
        if (cell.level == kEmptyProbeSlot) continue;
        ++cells;
        uint slot = probe_cell_slot(cell.at, cell.level, probeGrid.item.slots);
        while (probeCells.items[slot].level != kEmptyProbeSlot && slot != i) slot = (slot + 1u) % probeGrid.item.slots;
        if (slot == i && holds_probes(cell)) ++right;
    }
    counts.items[0] = probeGrid.item.probes;
    counts.items[1] = cells;
    counts.items[2] = right;
    counts.items[3] = probeGrid.item.levels;
    ++counts.items[4];  // Number of frames.
}
