// The region that a light reaches, as a convex body in view space. The tests below find out whether the body is
// separate from a box. Units: metres. Requires pixel_box.glsl.
//
// The same form fits all types of lights. A core (a point, a segment or a rectangle) is surrounded, at each of its
// points, by a part of a ball: the whole ball (point, capsule), the half in front (rectangle), or the part inside a
// cone (spot). A formula gives how far such a body extends in any direction. If a box begins beyond this extent in some
// direction, body and box are separate (separating axis theorem; Gottschalk, Lin and Manocha, OBBTree, 1996). Two
// directions are tested. The first is from the core to the box; this test is exact for a ball around a point. The
// second is the normal of the cone's side that faces the box.

struct Reach {
    vec3 center;
    float range_m;
    // Half of the segment, or half of one side of the rectangle, as a vector. `second`: half of the other side.
    vec3 first;
    float cos_spread;  // Cosine of half the cone's opening angle; −1: a whole ball.
    vec3 second;
    float sin_spread;
    vec3 direction;    // Axis of the cone.
    float slack_m;     // Allowance for rounding in single precision. range_m includes this allowance.
};

float core_extent(Reach r, vec3 n) { return abs(dot(n, r.first)) + abs(dot(n, r.second)); }

// Returns how far the body extends from its centre in the direction of n, times the length of n.
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

// Returns true if the box is beyond the extent of the light in the direction from the core to the box.
bool beyond_range(Reach r, Box box) {
    // `core` and `place` need not be the nearest points: any direction can prove that light and box are separate.
    const vec3 core = nearest_on_core(r, clamp(r.center, box.low, box.high));
    const vec3 place = clamp(core, box.low, box.high);
    const vec3 gap = place - core;
    const float gap_m = length(gap);
    return gap_m > r.slack_m && dot(gap, place - r.center) > extent(r, gap, gap_m);
}

// Returns true if the box is beside the cone. The test direction is the normal of the cone's side that faces the
// box.
bool beside_cone(Reach r, Box box) {
    if (r.cos_spread < 0.0) return false;  // A ball, or a cone whose edge is 90° or more from its axis.
    const vec3 low = box.low - r.center, high = box.high - r.center;
    const vec3 aside = cross(cross(r.direction, low + high), r.direction);
    const vec3 across = aside * inversesqrt(max(dot(aside, aside), 1e-30));
    const vec3 n = r.cos_spread * across - r.sin_spread * r.direction;
    const vec3 nearest = min(n * low, n * high);
    return nearest.x + nearest.y + nearest.z > core_extent(r, n) + r.slack_m;
}

bool reaches(Reach r, Box box) { return !beyond_range(r, box) && !beside_cone(r, box); }
