// The buffer `probeMap` of graphs/modules/probe_map.json contains the grid, the probes and the cells of the irradiance
// probes. So a pass that lights surfaces needs only one port for all of them. The items of the buffer are: the grid
// (kProbeGridItems), one item for each probe (ProbePoint), and kProbeCellItems for each slot of the table of cells
// (ProbeCell). There is room for at least one probe.
#ifndef WEFT_PROBE_MAP
#define WEFT_PROBE_MAP
#include "shared/probe_grid.glsl"

const uint kProbeGridItems = 4u;
const uint kProbeCellItems = 4u;
// The octahedral maps in `probeMoments` have this many texels per side, without the border.
const uint kProbeMomentSide = 32u;

// Returns the first item of the table of cells.
uint first_cell_item(uint probes) { return kProbeGridItems + max(probes, 1u); }
#endif
