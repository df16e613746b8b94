// Light of capsules and rectangles that emit uniformly. Vector irradiance means ∫ ω dω over the solid angle
// of the light (sr), for unit radiance; its dot product with a normal is the irradiance divided by the
// radiance. Vector irradiance is ½ ∮ r × dr along the outline of the light, where r is a direction (Lambert
// 1760; Baum, Rushmeier and Winget 1989). Outline of a rectangle: great-circle arcs, clipped at the horizon (the plane
// of the surface). Outline of a capsule: two great-circle arcs and, at the ends, two small-circle arcs. The
// fitted formula for an angle divided by its sine is from Heitz, Dupuy, Hill and Neubelt 2016, "Real-Time
// Polygonal-Light Shading with Linearly Transformed Cosines".
// Highlights: representative points, Karis 2013, "Real Shading in Unreal Engine 4".
#ifndef WEFT_AREA_LIGHTS
#define WEFT_AREA_LIGHTS
#include "brdf.glsl"
#include "lights.glsl"

struct AreaIncident {
    float irradiance;   // Irradiance on the surface, for unit radiance of the light.
    vec3 whole;         // Vector irradiance; of a rectangle, only its part above the horizon.
    float window;       // Factor of the range limit of the light: 1 near the light, 0 beyond its range.
    vec3 center;        // Direction of `whole`: from the surface to the middle of the light.
    vec3 mirrored;      // Direction from the surface to the point of the light used for the highlight.
    float aspect;       // Ratio of length to width of the light, as seen from the surface.
    vec3 along;         // Length axis of the light, made perpendicular to the line of sight; not normalised.
};

// Returns atan(y, x) with an error of 2e-7. The error of the built-in function can be 2e-4. This would be visible: when
// only a small part of the light is above the horizon, its light is the difference of two nearly equal angles, so the
// errors of the angles are large compared with the difference. The polynomial is atanf() of Moshier's Cephes library,
// 1992.
float angle_of(float y, float x) {
    const float longer = max(max(abs(x), abs(y)), 1e-30), shorter = min(abs(x), abs(y));
    const bool steep = shorter > 0.41421356 * longer;
    const float t = steep ? (shorter - longer) / (shorter + longer) : shorter / longer, t2 = t * t;
    const float fit = ((0.0805374450 * t2 - 0.138776856) * t2 + 0.199777106) * t2 - 0.333329492;
    float angle = fit * t2 * t + t + (steep ? 0.25 * kPi : 0.0);
    if (abs(y) > abs(x)) angle = 0.5 * kPi - angle;
    if (x < 0.0) angle = kPi - angle;
    return y < 0.0 ? -angle : angle;
}

// Returns ∫ r × dr along the great circle from direction a to direction b. a and b need not have unit length.
vec3 edge_integral(vec3 a, vec3 b) {
    const float scale = inversesqrt(max(dot(a, a) * dot(b, b), 1e-30));
    const float x = dot(a, b) * scale, y = abs(x);
    const float fit = 6.28318530718 * (0.8543985 + (0.4965155 + 0.0145206 * y) * y) / (3.4175940 + (4.1616724 + y) * y);
    const float arc_over_sine = x > 0.0 ? fit : kPi * inversesqrt(max(1.0 - x * x, 1e-7)) - fit;
    // The cross product uses b − a, because a × b would lose all significant digits if a and b are nearly equal.
    return cross(a, b - a) * (scale * arc_over_sine);
}

// Returns edge_integral() of the part of the edge from a to b that is above the horizon. If the edge crosses the
// horizon, stores the crossing in `down` or in `up`, depending on the direction of the edge.
vec3 edge_above(vec3 n, vec3 a, vec3 b, inout vec3 down, inout vec3 up) {
    const float height_a = dot(n, a), height_b = dot(n, b);
    if (height_a <= 0.0 && height_b <= 0.0) return vec3(0.0);
    vec3 from = a, to = b;
    if (height_a <= 0.0) from = up = a + (b - a) * (height_a / (height_a - height_b));
    if (height_b <= 0.0) to = down = a + (b - a) * (height_a / (height_a - height_b));
    return edge_integral(from, to);
}

// Returns the vector irradiance of the part of a rectangle above the horizon. Arguments: its middle, and vectors of
// half its width and height; the vector x × y must point away from the surface. Compilers inline every
// call, so this file uses loops to keep the compiled code short. Without the loops, this file was two thirds
// of the code of shaders with area lights.
vec3 rectangle_above(vec3 n, vec3 middle, vec3 x, vec3 y) {
    vec3 down = vec3(0.0), up = vec3(0.0), sum = vec3(0.0), to_side = -x, to_next = -y;
    [[dont_unroll]] for (int i = 0; i < 4; ++i) {
        const vec3 turned = -to_side;
        sum += edge_above(n, middle + to_side + to_next, middle - to_side + to_next, down, up);
        to_side = to_next;
        to_next = turned;
    }
    return 0.5 * (sum + edge_integral(down, up));
}

// Returns the point of the rectangle nearest to where the mirrored ray meets its plane. All vectors are in the frame of
// the light: width, height, direction. `at` is the start of the ray.
vec2 rectangle_target(vec3 at, vec3 ray, vec2 half_size) {
    const float steps = ray.z < -1e-4 * at.z ? -at.z / ray.z : 1e4;
    return clamp(at.xy + ray.xy * steps, -half_size, half_size);
}

AreaIncident rectangle_at(vec3 n, vec3 v, vec3 position, Light light) {
    AreaIncident incident = AreaIncident(0.0, vec3(0.0), 0.0, n, n, 1.0, vec3(0.0));
    const vec3 up = cross(light.side, light.direction), way = position - light.position;
    const vec3 at = vec3(dot(way, light.side), dot(way, up), dot(way, light.direction));
    if (at.z <= 0.0) return incident;
    const vec3 outside = vec3(max(abs(at.xy) - light.half_size_m, 0.0), at.z);
    incident.window = distance_window(dot(outside, outside), light.range_m);
    if (incident.window <= 0.0) return incident;
    const vec3 x = light.side * light.half_size_m.x, y = up * light.half_size_m.y;
    incident.whole = rectangle_above(n, -way, x, y);
    incident.irradiance = max(dot(n, incident.whole), 0.0);
    const vec3 ray = reflect(-v, n);
    const vec2 target =
        rectangle_target(at, vec3(dot(ray, light.side), dot(ray, up), dot(ray, light.direction)), light.half_size_m);
    incident.mirrored = normalize(light.side * target.x + up * target.y - way);
    incident.center = incident.irradiance > 0.0 ? normalize(incident.whole) : n;
    const vec3 sight = normalize(way);
    // A side of the rectangle that is seen at an angle looks shorter.
    const vec2 slant = sqrt(max(vec2(1.0) - at.xy * at.xy / dot(at, at), vec2(1e-4)));
    incident.along = light.side - sight * dot(light.side, sight);
    incident.aspect = (light.half_size_m.x * slant.x) / (light.half_size_m.y * slant.y);
    return incident;
}

// The silhouette of a capsule as seen from the origin. `axis` and `away` span the plane that contains the origin and
// the axis segment of the capsule.
struct Silhouette {
    vec3 axis;
    vec3 away;          // Direction from the origin to the axis, perpendicular to the axis.
    float distance;     // Distance of the axis from the origin.
    // Two planes through the origin, parallel to the axis, touch the side of the capsule along one line each.
    float tangent;      // Distance of these two lines from the origin.
    vec2 ends;          // Positions along the axis where the segment begins and ends.
    float radius;
};

Silhouette silhouette_of(vec3 middle, vec3 axis, vec2 half_size) {
    Silhouette s;
    s.axis = axis;
    const float along = dot(middle, axis);
    vec3 across = middle - axis * along;
    const vec3 steep = abs(axis.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0);
    if (dot(across, across) < 1e-12) across = cross(axis, steep) * 1e-6;
    s.distance = length(across);
    s.away = across / s.distance;
    s.ends = along + vec2(-half_size.x, half_size.x);
    // For a point inside the capsule, compute the light as for a point on its surface.
    const float nearest = length(vec2(max(abs(along) - half_size.x, 0.0), s.distance));
    s.radius = min(half_size.y, 0.999 * nearest);
    s.tangent = sqrt(max(s.distance * s.distance - s.radius * s.radius, 0.0));
    return s;
}

// Returns half the angle of the arc around the end at position z on the axis. `outward`: −1 first end, +1 second end.
float end_arc(Silhouette s, float z, float outward) {
    const float length2 = z * z + s.distance * s.distance;
    const float grazing = sqrt(max(length2 - s.radius * s.radius, 1e-20));
    return angle_of(sqrt(length2) * s.tangent / (s.distance * grazing), outward * z * s.radius / (s.distance * grazing));
}

// Returns the part of ∮ r × dr that comes from the arc at one end. Components: along the axis, and along `away`.
vec2 end_integral(Silhouette s, float z, float outward) {
    const float length2 = z * z + s.distance * s.distance, r2 = s.radius * s.radius;
    const vec2 to_middle = vec2(z, s.distance), across = vec2(s.distance, -z) * outward;
    return 2.0 * end_arc(s, z, outward) * r2 / (length2 * sqrt(length2)) * to_middle -
           2.0 * s.radius * s.tangent / (s.distance * length2) * across;
}

// Returns the angle between the directions to both ends of a long side of the silhouette.
float side_angle(Silhouette s) {
    return angle_of(s.tangent * (s.ends.y - s.ends.x), s.tangent * s.tangent + s.ends.x * s.ends.y);
}

vec3 capsule_whole(Silhouette s) {
    vec2 plane = vec2(0.0, 2.0 * side_angle(s) * s.radius / s.distance);
    [[dont_unroll]] for (float outward = -1.0; outward < 2.0; outward += 2.0)
        plane += end_integral(s, outward < 0.0 ? s.ends.x : s.ends.y, outward);
    return 0.5 * (s.axis * plane.x + s.away * plane.y);
}

// Returns the integral of n · (r × dr) over an arc, without its parts below the horizon. The arc is
// r(φ) = c + u cos φ + w sin φ, for φ within ±half_arc. u and w have the same length and are perpendicular to c.
float arc_above(vec3 n, vec3 c, vec3 u, vec3 w, float half_arc) {
    const float cos2 = dot(c, c), sin2 = dot(u, u);
    const float height = dot(n, c), x = dot(n, u), y = dot(n, w), swing = max(length(vec2(x, y)), 1e-20);
    const float top = angle_of(y, x), reach = angle_of(sqrt(max(swing * swing - height * height, 0.0)), -height);
    const float turn = sin2 * height * inversesqrt(max(cos2, 1e-20)), sway = sqrt(cos2);
    float sum = 0.0;
    [[dont_unroll]] for (int k = -1; k <= 1; ++k) {
        const float middle = top + 6.28318530718 * float(k);
        const float from = clamp(middle - reach, -half_arc, half_arc), to = clamp(middle + reach, -half_arc, half_arc);
        sum += turn * (to - from) - sway * (x * (sin(to) - sin(from)) - y * (cos(to) - cos(from)));
    }
    return sum;
}

// The part of the horizon that the light covers. `first` is the first crossing of the light's outline and the horizon
// that was found. `azimuths` are the smallest and largest angle from `first` to the other crossings, in radians.
struct Horizon {
    vec3 first;
    vec2 azimuths;
    bool crossed;
};

void note_crossing(inout Horizon horizon, vec3 n, vec3 at) {
    if (!horizon.crossed) {
        horizon.first = at;
        horizon.crossed = true;
        return;
    }
    const float azimuth = angle_of(dot(n, cross(horizon.first, at)), dot(horizon.first, at));
    horizon.azimuths = vec2(min(horizon.azimuths.x, azimuth), max(horizon.azimuths.y, azimuth));
}

void note_circle(inout Horizon horizon, vec3 n, vec3 c, vec3 u, vec3 w) {
    const float height = dot(n, c), x = dot(n, u), y = dot(n, w), swing = length(vec2(x, y));
    if (abs(height) >= swing) return;
    const vec3 top = (u * x + w * y) / swing, level = (u * y - w * x) / swing;
    const float cosine = -height / swing, sine = sqrt(1.0 - cosine * cosine);
    [[dont_unroll]] for (float side = 1.0; side > -2.0; side -= 2.0)
        note_crossing(horizon, n, c + top * cosine + level * (sine * side));
}

float end_above(Silhouette s, vec3 n, float z, float outward, inout Horizon horizon) {
    const vec3 to_middle = s.axis * z + s.away * s.distance;
    const float inverse_length = inversesqrt(dot(to_middle, to_middle));
    const float sine = min(s.radius * inverse_length, 1.0), cosine = sqrt(1.0 - sine * sine);
    const vec3 a = to_middle * inverse_length;
    const vec3 u = (s.axis * s.distance - s.away * z) * (outward * inverse_length * sine), w = cross(a, u);
    note_circle(horizon, n, a * cosine, u, w);
    return arc_above(n, a * cosine, u, w, end_arc(s, z, outward));
}

float side_above(Silhouette s, vec3 n, float side, inout Horizon horizon) {
    const vec3 across = cross(s.axis, s.away);
    const float sine = s.radius / s.distance, cosine = s.tangent / s.distance;
    const vec3 touch = (s.away * cosine + across * (sine * side)) * s.tangent;
    vec3 a = touch + s.axis * s.ends.x, b = touch + s.axis * s.ends.y;
    if (side < 0.0) {
        const vec3 swapped = a;
        a = b;
        b = swapped;
    }
    vec3 down = vec3(0.0), up = vec3(0.0);
    const vec3 sum = edge_above(n, a, b, down, up);
    const vec3 crossing = down != vec3(0.0) ? down : up;  // A side crosses the horizon at most once, either down or up.
    if (crossing != vec3(0.0)) note_crossing(horizon, n, crossing);
    return dot(n, sum);
}

// Returns the irradiance of a capsule that the horizon intersects, for unit radiance.
float capsule_above(Silhouette s, vec3 n) {
    Horizon horizon = Horizon(vec3(0.0), vec2(0.0), false);
    float sum = 0.0;
    // `whole` is false if the capsule is seen along its axis. Then only its nearer end is visible.
    const bool whole = s.tangent > 0.0, first = abs(s.ends.x) < abs(s.ends.y);
    [[dont_unroll]] for (float outward = -1.0; outward < 2.0; outward += 2.0) {
        if (whole) sum += side_above(s, n, -outward, horizon);
        if (whole || first == (outward < 0.0))
            sum += end_above(s, n, outward < 0.0 ? s.ends.x : s.ends.y, outward, horizon);
    }
    return max(0.5 * (sum + horizon.azimuths.y - horizon.azimuths.x), 0.0);
}

// Returns the point of the capsule that is nearest to the mirrored ray.
vec3 capsule_target(vec3 middle, vec3 axis, vec2 half_size, vec3 ray) {
    const float along = dot(ray, axis);
    const float shift = (dot(ray, middle) * along - dot(middle, axis)) / max(1.0 - along * along, 1e-4);
    const vec3 next = middle + axis * clamp(shift, -half_size.x, half_size.x);
    const vec3 to_ray = ray * dot(ray, next) - next;
    return next + to_ray * min(1.0, half_size.y * inversesqrt(max(dot(to_ray, to_ray), 1e-20)));
}

AreaIncident capsule_at(vec3 n, vec3 v, vec3 position, Light light) {
    AreaIncident incident = AreaIncident(0.0, vec3(0.0), 0.0, n, n, 1.0, vec3(0.0));
    const vec3 middle = light.position - position, axis = light.direction;
    const vec3 nearest = middle - axis * clamp(dot(middle, axis), -light.half_size_m.x, light.half_size_m.x);
    incident.window = distance_window(dot(nearest, nearest), light.range_m);
    const float lift = dot(n, middle), tilt = abs(dot(n, axis)) * light.half_size_m.x;
    if (incident.window <= 0.0 || lift + tilt <= -light.half_size_m.y) return incident;
    const Silhouette s = silhouette_of(middle, axis, light.half_size_m);
    incident.whole = capsule_whole(s);
    const bool all_above = lift - tilt >= light.half_size_m.y;
    incident.irradiance = all_above ? max(dot(n, incident.whole), 0.0) : capsule_above(s, n);
    incident.center = normalize(incident.whole);
    incident.mirrored = normalize(capsule_target(middle, axis, light.half_size_m, reflect(-v, n)));
    const vec3 sight = normalize(middle);
    incident.along = axis - sight * dot(axis, sight);
    const float foreshortened = light.half_size_m.x * length(incident.along);
    incident.aspect = (foreshortened + light.half_size_m.y) / light.half_size_m.y;
    return incident;
}

// Returns the highlight of an area light. This is the highlight of the representative point of the light, divided by
// 1 + `added`, because the light widens the highlight. As a function of the half vector, the GGX distribution is
// 1 / (π α²) at the centre of the highlight, and its integral along a line from the centre is 1 / (4 α). For a light
// with sides 2a and 2b, `added` is a term for the area of the light, 4ab / (π α²), plus a term for its outline,
// (a + b) / α (Steiner's formula). a and b are angles between half vectors. In the plane of incidence, the angle
// between two half vectors is half of the angle between the two light directions. Perpendicular to this plane, the
// angle is half of that angle divided by v·h. For a perfect mirror, the result is the radiance of the light.
vec3 area_highlight(Surface s, vec3 v, AreaIncident incident) {
    const float covered = max(length(incident.whole), 1e-20);
    const float v_h = max(dot(v, normalize(v + incident.mirrored)), 0.05);
    const vec3 normal = cross(v, incident.mirrored), along = incident.along;
    const float upright = dot(normal, along) * dot(normal, along) / max(dot(normal, normal) * dot(along, along), 1e-12);
    const float a = 0.25 * sqrt(covered * incident.aspect * (1.0 + upright * (1.0 / (v_h * v_h) - 1.0)));
    const float b = covered / (16.0 * v_h * a);
    const float added = (a + b) / s.alpha + 4.0 * a * b / (kPi * s.alpha * s.alpha);
    Surface coat = s;
    coat.diffuse = vec3(0.0);
    return reflect_light(coat, v, incident.mirrored) * (covered / (1.0 + added));
}

// Returns the radiance that the surface reflects to the eye, for a light of unit radiance.
vec3 reflect_area(Surface s, vec3 v, vec3 position, Light light) {
    AreaIncident incident;
    if (light.type == kLightRectangle) {
        incident = rectangle_at(s.normal, v, position, light);
    } else {
        incident = capsule_at(s.normal, v, position, light);
    }
    if (incident.irradiance <= 0.0 || incident.window <= 0.0) return vec3(0.0);
    const vec3 f = schlick(s.f0, s.f90, dot(v, normalize(v + incident.center)));
    const vec3 matt = base_under_coat(s, f) * (incident.irradiance / kPi);
    return (matt + area_highlight(s, v, incident)) * incident.window;
}
#endif
