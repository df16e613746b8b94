// What a light reaches, as a convex body in view space, and whether a box or a half-space lies apart from it. Needs
// pixel_box.glsl. Units: metres.
//
// One body for all types: a core, which is a point, a segment or a rectangle, and around each of its points the part of a
// ball that lies within a cone: all of it (point, capsule), the half that a rectangle shines to, or a spot's cone. Of such a
// body the furthest extent in any direction has a closed form, and a direction in which a box begins beyond that extent
// proves that the two are apart (separating axis theorem; Gottschalk, Lin and Manocha, OBBTree, 1996). The directions tried
// are the one from the core to the box, exact for balls, and the cone's own normal towards the box.

struct Reach {
    vec3 center;
    float range_m;
    vec3 first;        // half of the core's sides
    float cos_spread;  // the cone's half angle; −1: a whole ball
    vec3 second;
    float sin_spread;
    vec3 direction;    // the cone's axis
    float slack_m;     // what single precision may have lost; range_m has it in
};

float core_extent(Reach r, vec3 n) { return abs(dot(n, r.first)) + abs(dot(n, r.second)); }

// How far the body goes from its centre in the direction of n, times the length of n.
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

// Whether the box begins beyond the light's end, seen from the core towards the box.
bool beyond_range(Reach r, Box box) {
    // Close to each other; that others may be closer is of no matter for what is proved with them.
    const vec3 core = nearest_on_core(r, clamp(r.center, box.low, box.high));
    const vec3 place = clamp(core, box.low, box.high);
    const vec3 gap = place - core;
    const float gap_m = length(gap);
    return gap_m > r.slack_m && dot(gap, place - r.center) > extent(r, gap, gap_m);
}

// Whether the box lies beside the cone, whose surface ends in every direction that is square to it at the core.
bool beside_cone(Reach r, Box box) {
    if (r.cos_spread < 0.0) return false;  // not convex then
    const vec3 low = box.low - r.center, high = box.high - r.center;
    const vec3 aside = cross(cross(r.direction, low + high), r.direction);
    const vec3 across = aside * inversesqrt(max(dot(aside, aside), 1e-30));
    const vec3 n = r.cos_spread * across - r.sin_spread * r.direction;
    const vec3 nearest = min(n * low, n * high);
    return nearest.x + nearest.y + nearest.z > core_extent(r, n) + r.slack_m;
}

bool reaches(Reach r, Box box) { return !beyond_range(r, box) && !beside_cone(r, box); }
