// One light of the buffer that the pass type light_upload writes. Units: metres, candela (point, spot), lux
// (directional), cd/m² (capsule, rectangle).
#ifndef WEFT_SHARED_LIGHT
#define WEFT_SHARED_LIGHT
#include "begin.glsl"

const uint kLightDirectional = 0u;
const uint kLightPoint = 1u;
const uint kLightSpot = 2u;
const uint kLightCapsule = 3u;
const uint kLightRectangle = 4u;

// Number of directional lights that can have shadows: the first ones in the buffer.
const uint kMostSuns = 4u;

struct Light {
    vec3 position;       // Centre of the light, in world space.
    float range_m;       // Range, from the nearest point of the light's shape; 0: no limit.
    vec3 intensity;      // Colour × intensity in the unit of the light type, Rec.709.
    uint type;
    vec3 direction;      // Unit vector along which the light travels; for a capsule, its axis.
    // Spot: the light has the factor saturate(cos(angle) · cone_scale + cone_offset)², as in KHR_lights_punctual.
    // Directional light: it has no cone, so cone_scale is the angular radius of its disc in radians.
    float cone_scale;
    // Unit vector perpendicular to `direction`: the width axis of a rectangle, and the width axis of the doors and of
    // the picture of the light. For a capsule: the direction that its doors and its picture face.
    vec3 side;
    float cone_offset;
    vec2 half_size_m;    // Rectangle: half width, half height; capsule: half length without caps, radius.
    uint function;       // 0: no light function; otherwise 1 + the index of the light function.
    // 0: no shadow; 1 to kMostSuns: the number of a directional light with shadows. Directional light 1 has the cascades
    // of sun_shadow.glsl, the other directional lights have the shadow maps of further_sun_shadow.glsl. From
    // kFirstLampMap on: a lamp with the shadow maps of lamp_shadow.glsl, only in the buffer of light_upload.
    uint shadow;
};

#include "end.glsl"
#endif
