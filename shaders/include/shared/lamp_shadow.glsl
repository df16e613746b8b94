// Shadow maps of lamps. A spot light with a narrow cone has one map. Every other lamp has six maps in a row: the faces of
// a cube around its middle, in the order +x −x +y −y +z −z. Depth in a map is kLampMapNear_m · (1 / w − 1 / r), where w is
// the distance from the lamp along the axis of the view. r is the distance that the light of the lamp can reach: its range
// plus both half sizes. 1 / r is 0 if the lamp has no range.
#ifndef WEFT_SHARED_LAMP_SHADOW
#define WEFT_SHARED_LAMP_SHADOW
#include "begin.glsl"

const float kLampMapNear_m = 0.05f;
// A spot light has one map if the cosine of half its angle is at least this number (60 degrees).
const float kLeastSpotCosine = 0.5f;
// A map is wider than the cone or the face by this factor, so that filters find texels beyond the edge.
const float kLampMapMargin = 1.1f;
// Light::shadow of a lamp with shadow maps is this number plus the number of its first map.
const uint kFirstLampMap = 5u;

#include "end.glsl"
#endif
