// Computes a bounding sphere of the region that a light reaches. Units: metres, world space.
#ifndef WEFT_LIGHT_SPHERE
#define WEFT_LIGHT_SPHERE
#include "lights.glsl"

// Returns centre and radius of the sphere. The light must have a position and a range. A spot gets the
// smallest sphere around its cone. If the edge of the cone is at most 45° from the axis, this sphere passes
// through the tip and the rim. From 45° to 90°, the rim is the equator of the sphere. From 90° on, the sphere
// is that of a point light.
vec4 light_sphere(Light light) {
    const float range_m = light.range_m;
    if (light.type == kLightCapsule) return vec4(light.position, light.half_size_m.x + range_m);
    if (light.type == kLightRectangle) return vec4(light.position, length(light.half_size_m) + range_m);
    const float edge = cone_edge(light);
    if (light.type != kLightSpot || edge <= 0.0) return vec4(light.position, range_m);
    if (edge * edge >= 0.5) {
        const float radius_m = range_m * 0.5 / edge;
        return vec4(light.position + light.direction * radius_m, radius_m);
    }
    return vec4(light.position + light.direction * (range_m * edge), range_m * sqrt(1.0 - edge * edge));
}
#endif
