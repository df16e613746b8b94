// Draws a light volume for each light: one instance of a convex solid around the region that the light
// reaches. The solid of a point light is an icosahedron, of a spot a pyramid with ten sides, of a capsule or
// rectangle a box. A spot whose cone edge is 60° or more from its axis gets an icosahedron, too. Lights
// without a range cover the whole picture.
//
// Each volume is drawn twice in one draw; primitives are rasterised in order. First, its back faces set the stencil
// where the surface is in front of them. Then its front faces shade the pixels with a set stencil whose surface is
// behind them, and clear the stencil. Triangles with the other orientation are collapsed. If the eye or the near plane
// is inside the volume, the near plane would clip the front faces. In this case the second drawing uses the back faces
// again, at the depth of the near plane. The shader reverses the orientation of these back faces, so that they count as
// front faces. Depth is reversed. Volumes are 1 % too large, so that rounding errors at their edges are invisible.
#version 460
#include "frame_set.glsl"
#include "shared/light.glsl"
#include "light_sphere.glsl"

layout(std430) readonly buffer Lights { Light items[]; } lights;

layout(location = 0) flat out uint light_index;

const int kTriangles = 20;
const float kMargin = 1.01;
const float kPi = 3.14159265358979;
const int kSides = 10;
// Margin × circumradius / inradius of the polygon of the rim.
const float kAroundCircle = kMargin / cos(kPi / float(kSides));
// Margin × circumradius / inradius of the icosahedron.
const float kAroundSphere = kMargin * 1.258408572;

const float kGolden = 1.618033988750;
const vec3 kIcosahedron[12] = vec3[](
    vec3(-1, kGolden, 0), vec3(1, kGolden, 0), vec3(-1, -kGolden, 0), vec3(1, -kGolden, 0),
    vec3(0, -1, kGolden), vec3(0, 1, kGolden), vec3(0, -1, -kGolden), vec3(0, 1, -kGolden),
    vec3(kGolden, 0, -1), vec3(kGolden, 0, 1), vec3(-kGolden, 0, -1), vec3(-kGolden, 0, 1));
const uvec3 kIcosahedronFaces[kTriangles] = uvec3[](
    uvec3(0, 11, 5), uvec3(0, 5, 1), uvec3(0, 1, 7), uvec3(0, 7, 10), uvec3(0, 10, 11), uvec3(1, 5, 9), uvec3(5, 11, 4),
    uvec3(11, 10, 2), uvec3(10, 7, 6), uvec3(7, 1, 8), uvec3(3, 9, 4), uvec3(3, 4, 2), uvec3(3, 2, 6), uvec3(3, 6, 8),
    uvec3(3, 8, 9), uvec3(4, 9, 5), uvec3(2, 4, 11), uvec3(6, 2, 10), uvec3(8, 6, 7), uvec3(9, 8, 1));
const uvec3 kBoxFaces[12] = uvec3[](  // Bit i of a corner's number selects the end of axis i.
    uvec3(1, 3, 7), uvec3(1, 7, 5), uvec3(0, 4, 6), uvec3(0, 6, 2), uvec3(2, 6, 7), uvec3(2, 7, 3),
    uvec3(0, 1, 5), uvec3(0, 5, 4), uvec3(4, 5, 7), uvec3(4, 7, 6), uvec3(0, 2, 3), uvec3(0, 3, 1));

const int kEverywhere = 0;
const int kSphere = 1;
const int kCone = 2;
const int kBox = 3;

// The solid around a light, in its own axes: side, up and back.
struct Proxy {
    int shape;
    mat3 axes;
    vec3 center;      // Centre of the solid; for a cone, its tip.
    vec3 extent;      // Sphere: radius; cone: rim radius (x, y), height (z); box: half sizes.
};

Proxy make_proxy(Light light) {
    Proxy proxy;
    proxy.axes = mat3(light.side, cross(light.side, light.direction), -light.direction);
    proxy.center = light.position;
    const float range_m = light.range_m;
    const float edge = cone_edge(light);
    if (range_m <= 0.0) {
        proxy.shape = kEverywhere;
        proxy.extent = vec3(0.0);
    } else if (light.type == kLightCapsule) {
        proxy.shape = kBox;
        proxy.extent = kMargin * (vec3(range_m) + vec3(0.0, 0.0, light.half_size_m.x));
    } else if (light.type == kLightRectangle) {
        proxy.shape = kBox;
        proxy.center += light.direction * (0.5 * range_m);
        proxy.extent = kMargin * vec3(light.half_size_m + range_m, 0.5 * range_m);
    } else if (light.type == kLightSpot && edge > 0.5) {
        const float back_m = range_m * (kMargin - 1.0);
        proxy.shape = kCone;
        proxy.center -= light.direction * back_m;
        const float height_m = range_m * kMargin + back_m;
        const float rim_m = height_m * kAroundCircle * sqrt(1.0 - edge * edge) / edge;
        proxy.extent = vec3(rim_m, rim_m, height_m);
    } else {
        proxy.shape = kSphere;
        proxy.extent = vec3(kAroundSphere * range_m);
    }
    return proxy;
}

vec3 rim(int at) {
    const float turn = float(at % kSides) * (2.0 * kPi / float(kSides));
    return vec3(cos(turn), sin(turn), -1.0);
}

// Returns a corner of a triangle of the solid, counter-clockwise as seen from outside. Triangles that a solid does not
// need are collapsed to a point.
vec3 corner_of(Proxy proxy, int triangle, int corner) {
    vec3 at = vec3(0.0);
    if (proxy.shape == kSphere)
        at = normalize(kIcosahedron[kIcosahedronFaces[triangle][corner]]);
    else if (proxy.shape == kCone && triangle < kSides)
        at = corner == 0 ? at : rim(triangle + corner - 1);
    else if (proxy.shape == kCone && triangle < 2 * kSides - 2)
        at = rim(corner == 0 ? 0 : triangle - kSides + 3 - corner);
    else if (proxy.shape == kBox && triangle < 12)
        at = vec3((uvec3(kBoxFaces[triangle][corner]) >> uvec3(0, 1, 2)) & 1u) * 2.0 - 1.0;
    return proxy.center + proxy.axes * (at * proxy.extent);
}

// Returns a corner of a triangle that covers the whole picture at the far plane. The triangle is a back face.
vec4 picture_corner(int triangle, int corner) {
    if (triangle > 0) return vec4(0.0);
    return vec4(corner == 1 ? 3.0 : -1.0, corner == 2 ? 3.0 : -1.0, 0.0, 1.0);
}

// Returns true if a part of the near plane may be inside the volume.
bool surrounds_eye(Proxy proxy) {
    if (proxy.shape == kEverywhere) return true;
    const vec3 near_corner = vec3(1.0 / view.projection[0][0], 1.0 / view.projection[1][1], 1.0);
    const float near_m = kMargin * view.near_m * length(near_corner);
    const vec3 eye = (view.eye - proxy.center) * proxy.axes;
    if (proxy.shape == kSphere) return length(eye) < proxy.extent.x + near_m;
    if (proxy.shape == kBox) return all(lessThan(abs(eye), proxy.extent + near_m));
    const float slope = proxy.extent.x / proxy.extent.z;
    const float room_m = slope * -eye.z + near_m * sqrt(1.0 + slope * slope);
    return -eye.z > -near_m && -eye.z < proxy.extent.z + near_m && length(eye.xy) < room_m;
}

void main() {
    const uint first = frame.directional_count;
    const uint count = min(frame.light_count, uint(lights.items.length()));
    light_index = first + uint(gl_InstanceIndex);
    gl_Position = vec4(0.0, 0.0, -1.0, 1.0);
    if (light_index >= count) return;
    const Proxy proxy = make_proxy(lights.items[light_index]);
    const int triangle = (gl_VertexIndex / 3) % kTriangles;
    const bool shades = gl_VertexIndex >= 3 * kTriangles;
    vec4 corners[3];
    for (int i = 0; i < 3; ++i)
        corners[i] = proxy.shape == kEverywhere
                         ? picture_corner(triangle, i)
                         : view.view_projection * vec4(corner_of(proxy, triangle, i), 1.0);
    // The sign of the triangle's area on screen gives its orientation (for the part in front of the eye).
    const float turn = determinant(mat3(corners[0].xyw, corners[1].xyw, corners[2].xyw));
    const bool turned = shades && surrounds_eye(proxy);
    const bool is_wanted = shades && !turned ? turn < 0.0 : turn > 0.0;
    if (!is_wanted) return;
    const int corner = gl_VertexIndex % 3;
    gl_Position = corners[turned ? (3 - corner) % 3 : corner];
    if (turned) gl_Position.z = gl_Position.w;
}
