// The buffer `lamps`: the lamps that a light probe sees.
#ifndef WEFT_PROBE_LAMPS
#define WEFT_PROBE_LAMPS

// The buffer begins with one bit for each light of the scene: 1 if the probe sees the light. After kLampWords words,
// there is one number for each light: the share of the light's shape that the probe sees. The number is undefined if
// the bit is 0.
const uint kLampWords = 2048u;

#endif
