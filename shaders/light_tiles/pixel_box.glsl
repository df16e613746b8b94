// Boxes and planes in view space around the surfaces in a rectangle of pixels. Units: metres. All bounds refer to the
// centres of pixels, because surfaces are shaded there. Requires frame_set.glsl.

// Largest rounding error of a position in single precision, relative to its distance from the eye. This number covers
// the error of a box in this file and the error of the position that world_position() returns for the same pixel.
const float kPlaceError = 4e-6;
// Replaces infinity. The square of this number is still finite.
const float kEndless = 1e17;

struct Box {
    vec3 low, high;
};

// Limits of x and y, divided by the distance along the view axis, for a rectangle of pixels.
struct Slopes {
    vec2 low, high;
};

vec2 slope_of(vec2 pixel) {
    const vec2 clip = pixel * view.inverse_viewport * 2.0 - 1.0;
    return (clip + view.projection[2].xy) / vec2(view.projection[0].x, view.projection[1].y);
}

Slopes slopes_of(ivec2 first, ivec2 last) {
    const vec2 a = slope_of(vec2(first) + 0.5), b = slope_of(vec2(last) + 0.5);
    const vec2 error = kPlaceError * (1.0 + max(abs(a), abs(b)));
    return Slopes(min(a, b) - error, max(a, b) + error);
}

float distance_of(float z) { return min(view.near_m / z, kEndless); }

// Returns a box around the frustum of a rectangle of pixels, between two distances from the eye along the view axis.
Box box_of(Slopes s, float near_m, float far_m) {
    const float from_m = near_m * (1.0 - kPlaceError), to_m = far_m * (1.0 + kPlaceError);
    return Box(vec3(min(s.low * from_m, s.low * to_m), -to_m), vec3(max(s.high * from_m, s.high * to_m), -from_m));
}

// Normals of planes through the eye that bound a rectangle of pixels. They point inwards. The components are x and z
// for the left and right plane, y and z for the lower and upper plane.
struct SidePlanes {
    vec2 left, right, lower, upper;
};

SidePlanes planes_of(Slopes s) {
    return SidePlanes(normalize(vec2(1.0, s.low.x)), normalize(vec2(-1.0, -s.high.x)), normalize(vec2(1.0, s.low.y)),
                      normalize(vec2(-1.0, -s.high.y)));
}

bool sphere_inside(vec4 sphere, SidePlanes p) {
    const float nearest = min(min(dot(p.left, sphere.xz), dot(p.right, sphere.xz)),
                              min(dot(p.lower, sphere.yz), dot(p.upper, sphere.yz)));
    return nearest >= -sphere.w;
}

bool sphere_meets(vec4 sphere, Box box) {
    const vec3 gap = max(max(box.low - sphere.xyz, sphere.xyz - box.high), 0.0);
    return dot(gap, gap) <= sphere.w * sphere.w;
}
