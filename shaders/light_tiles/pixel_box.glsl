// Boxes and planes in view space around what a rectangle of pixels shows. Needs frame_set.glsl. Units: metres.
// Everything is made for the centres of pixels, because that is where surfaces are shaded.

// What single precision may lose of a place, as a share of its distance: of a box made here, and of the same pixel's place
// made by world_position().
const float kPlaceError = 4e-6;
// Instead of infinitely far; its square is still a number.
const float kEndless = 1e17;

struct Box {
    vec3 low, high;
};

// x and y over distance along the view: the lower and upper ends of what some pixels show.
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

// The pixels' part between two distances.
Box box_of(Slopes s, float near_m, float far_m) {
    const float from_m = near_m * (1.0 - kPlaceError), to_m = far_m * (1.0 + kPlaceError);
    return Box(vec3(min(s.low * from_m, s.low * to_m), -to_m), vec3(max(s.high * from_m, s.high * to_m), -from_m));
}

// Through the eye, inwards: x and z of the left and right ones, y and z of the lower and upper ones.
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
