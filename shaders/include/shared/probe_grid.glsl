// The irradiance probes of the scene as shaders see them: the imported buffers `probePoints`, `probeCells` and
// `probeGrid`. The probes have numbers from 0. A grid point without a probe (a dropped probe) has no number. The
// structs are for storage buffers. Units: metres.
#ifndef WEFT_SHARED_PROBE_GRID
#define WEFT_SHARED_PROBE_GRID
#include "begin.glsl"

// kNoProbe is the value of an element of ProbeCell::corners if there is no probe at this corner. kEmptyProbeSlot is the
// value of ProbeCell::level if the slot is empty.
const uint kNoProbe = 0xffffffffu;
const uint kEmptyProbeSlot = 0xffffffffu;
const uint kMostProbeLevels = 8u;
// Radiance is stored multiplied by this number, so that the sun on white (25,000 cd/m²) and lamps fit into half floats.
// The number is a power of two, so the multiplication does not round.
const float kProbeRadianceScale = 0.0625;

// One probe, an element of the buffer `probePoints`.
struct ProbePoint {
    vec3 position;    // In world space.
    float spacing_m;  // Spacing of the finest level of which the probe is a corner.
};

// One slot of the hash table `probeCells`. To find a cell, begin with the slot probe_cell_slot() and go on to the next
// slots, after the last one to the first one, until a slot has the same `at` and `level`, or is empty.
struct ProbeCell {
    ivec3 at;          // The corner with the smallest coordinates: see ProbeGrid.
    uint level;        // The side of the cell is the stride of this level times spacing_m.
    // Numbers of the probes at the corners. In the index of a corner, bit 0 means +x, bit 1 +y, bit 2 +z.
    uint corners[8];
    // Bit i is 1 if this cell has a neighbour in the direction (dx, dy, dz) at the same level, where each of dx, dy, dz
    // is −1, 0 or 1 and i = (dx + 1) + 3 (dy + 1) + 9 (dz + 1).
    uint neighbours;
    uint reserved[3];
};

// The only element of the buffer `probeGrid`. Grid point `at` is at origin + R · at · spacing_m, where R is the rotation
// by the angle of the grid. along_turned_grid() applies the inverse of R.
struct ProbeGrid {
    vec3 origin;      // Place of the grid point (0, 0, 0).
    float spacing_m;  // Distance between two neighbouring points of the finest grid.
    uint levels;      // Number of levels; 0: there are no cells. Level 0 is the finest.
    uint slots;       // Number of slots in `probeCells`, a power of two. At least half of them are empty.
    uint probes;
    // The tangent of half of the angle by which the grid is turned around +y, counter-clockwise as seen from above.
    float half_yaw_tangent;
    // The stride of level i, in units of spacing_m, is strides[i / 4][i % 4].
    uvec4 strides[kMostProbeLevels / 4u];
};

#ifndef __cplusplus
// Returns a way in world space along the axes of a grid with this ProbeGrid::half_yaw_tangent.
vec3 along_turned_grid(vec3 way, float half_yaw_tangent) {
    const float square = half_yaw_tangent * half_yaw_tangent;
    const float c = (1.0 - square) / (1.0 + square), s = 2.0 * half_yaw_tangent / (1.0 + square);
    return vec3(c * way.x - s * way.z, way.y, s * way.x + c * way.z);
}
#endif

// Returns the slot at which the search for a cell begins.
#ifdef __cplusplus
inline
#endif
uint probe_cell_slot(ivec3 at, uint level, uint slots) {
    uint mixed = uint(at.x) * 0x9e3779b1u + uint(at.y);
    mixed = (mixed ^ (mixed >> 15u)) * 0x85ebca77u + uint(at.z);
    mixed = (mixed ^ (mixed >> 13u)) * 0xc2b2ae3du + level;
    mixed = (mixed ^ (mixed >> 16u)) * 0x9e3779b1u;
    return (mixed ^ (mixed >> 15u)) & (slots - 1u);
}

#include "end.glsl"
#endif
