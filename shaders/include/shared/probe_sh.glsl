// The light of the irradiance probes: spherical harmonics in the buffer `probeSh`.
#ifndef WEFT_SHARED_PROBE_SH
#define WEFT_SHARED_PROBE_SH
#include "begin.glsl"

// Elements (vec4) of the buffer for each probe. The coefficients of probe p are the elements kProbeShStride · p to
// kProbeShStride · p + 8. Their rgb: irradiance / π is the sum of the coefficients times harmonic_basis(normal), in
// cd/m². w of the first element: 1 if the probe has been lit, otherwise 0. The other elements are unused. They exist
// because the range of each probe must begin at a multiple of 256 bytes.
const uint kProbeShStride = 16u;

#include "end.glsl"
#endif
