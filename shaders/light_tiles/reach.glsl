// The region that a light reaches, as a convex body in view space, and tests whether it is separate from a
// box or half-space. Requires pixel_box.glsl. Units: metres.
//
// One form covers all light types: a core (a point, a segment or a rectangle), and around each of its points
// the part of a ball inside a cone: the whole ball (point, capsule), the half in front of a rectangle, or a
// spot's cone. The extent of such a body in any direction has a closed form. If a box begins beyond that
// extent in some direction, the two are separate (separating axis theorem; Gottschalk, Lin and Manocha,
// OBBTree, 1996). Two directions are tested: from the core to the box, which is exact for balls, and the
// cone's normal towards the box.

struct Reach {
    vec3 center;
    float range_m;
    vec3 first;        // half side of the core
    float cos_spread;  // cosine of the cone's half angle; −1: a whole ball
    vec3 second;
    float sin_spread;
    vec3 direction;    // the cone's axis
    float slack_m;     // allowance for rounding in single precision; included in range_m
};

float core_extent(Reach r, vec3 n) { return abs(dot(n, r.first)) + abs(dot(n, r.second)); }

// Extent of the body from its centre in the direction of n, times the length of n.
float extent(Reach r, vec3 n, float length_n) {
    const float along = dot(n, r.direction);
    const float across = sqrt(max(length_n * length_n - along * along, 0.0));
    const float share = along >= r.cos_spread * length_n ? length_n : max(along * r.cos_spread + across * r.sin_spread, 0.0);
    return core_extent(r, n) + r.range_m * share + r.slack_m * length_n;
}

vec3 nearest_on_core(Reach r, vec3 place) {
    const vec3 p = place - r.center;
    const float u = clamp(dot(p, r.first) / max(dot(r.first, r.first), 1e-12), -1.0, 1.0);
    const float v = clamp(dot(p, r.second) / max(dot(r.second, r.second), 1e-12), -1.0, 1.0);
    return r.center + r.first * u + r.second * v;
}

// True if the box begins beyond the light's extent, in the direction from the core to the box.
bool beyond_range(Reach r, Box box) {
    // A pair of near points. They need not be the nearest ones, because any direction gives a valid proof.
    const vec3 core = nearest_on_core(r, clamp(r.center, box.low, box.high));
    const vec3 place = clamp(core, box.low, box.high);
    const vec3 gap = place - core;
    const float gap_m = length(gap);
    return gap_m > r.slack_m && dot(gap, place - r.center) > extent(r, gap, gap_m);
}

// True if the box lies beside the cone, outside the cone's surface in the direction perpendicular to its
// axis.
bool beside_cone(Reach r, Box box) {
    if (r.cos_spread < 0.0) return false;  // a ball has no cone; the formula below needs one
    const vec3 low = box.low - r.center, high = box.high - r.center;
    const vec3 aside = cross(cross(r.direction, low + high), r.direction);
    const vec3 across = aside * inversesqrt(max(dot(aside, aside), 1e-30));
    const vec3 n = r.cos_spread * across - r.sin_spread * r.direction;
    const vec3 nearest = min(n * low, n * high);
    return nearest.x + nearest.y + nearest.z > core_extent(r, n) + r.slack_m;
}

bool reaches(Reach r, Box box) { return !beyond_range(r, box) && !beside_cone(r, box); }
