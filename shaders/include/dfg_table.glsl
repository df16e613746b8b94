// Format of the table of directional albedo in the buffer `dfg`: rows of kDfgSide elements. An element contains three half
// floats: scale, bias, and 1 if several reflections are added, else 0.
#ifndef WEFT_DFG_TABLE
#define WEFT_DFG_TABLE

const uint kDfgSide = 64u;

uvec2 packed_dfg(vec3 element) { return uvec2(packHalf2x16(element.xy), packHalf2x16(vec2(element.z, 0.0))); }
vec3 unpacked_dfg(uvec2 element) { return vec3(unpackHalf2x16(element.x), unpackHalf2x16(element.y).x); }
#endif
