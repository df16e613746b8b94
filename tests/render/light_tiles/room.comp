// Writes the depth of the reference room for light culling: floor and ceiling 8 m apart, walls 16 m apart, far wall 60
// m away, two rows of columns and 60 spheres, seen from the origin along -z. Units: metres.
// Output `depth`: the distance of the near plane, divided by the distance of the surface that is visible at
// the pixel's centre. Both distances are measured along -z.
#version 460
#include "frame_set.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(r32f) writeonly uniform image2D depth;

const int kSpheres = 60;
const vec4 kSphere[kSpheres] = vec4[](  // centre in x, y, z; radius in w
    vec4(-3.336082, -1.489640, -42.182953, 0.482531),
    vec4(-3.519370, -0.872526, -44.337490, 0.541778),
    vec4(-0.139066, -1.420358, -30.528475, 0.308695),
    vec4(3.190895, -0.891724, -26.328810, 0.344655),
    vec4(-2.438394, 0.381642, -11.447455, 0.473313),
    vec4(-5.031105, -0.301082, -36.229813, 0.477789),
    vec4(-0.704289, -1.114919, -10.123943, 0.455749),
    vec4(4.559244, -1.378199, -15.333891, 0.231662),
    vec4(-1.029180, -1.361809, -16.323597, 0.501161),
    vec4(1.545455, -0.552649, -29.092701, 0.346854),
    vec4(1.199151, -0.136258, -14.961861, 0.155832),
    vec4(-2.583769, -1.413274, -14.411469, 0.480622),
    vec4(-2.069233, 0.066985, -9.487393, 0.506964),
    vec4(-4.012646, 0.316027, -46.376873, 0.374535),
    vec4(5.522720, -1.418903, -11.478660, 0.548396),
    vec4(-5.708321, -0.645197, -12.204999, 0.423966),
    vec4(2.398123, 0.086751, -38.078159, 0.396450),
    vec4(-5.724803, -0.473625, -28.994829, 0.297265),
    vec4(-5.980294, -0.218138, -26.196266, 0.476467),
    vec4(1.677542, 0.251287, -47.353100, 0.152294),
    vec4(-2.890829, -0.158881, -39.112362, 0.416824),
    vec4(4.445797, -1.200469, -44.523735, 0.428666),
    vec4(-5.973429, -0.449173, -24.126978, 0.381889),
    vec4(5.777625, -1.470986, -20.952517, 0.220898),
    vec4(3.764790, -0.916946, -27.590544, 0.393481),
    vec4(3.250250, -1.209050, -24.821899, 0.198619),
    vec4(-5.650661, 0.269359, -6.893656, 0.274392),
    vec4(-4.662554, -0.651367, -14.306030, 0.174885),
    vec4(5.578983, -1.049312, -31.429474, 0.240395),
    vec4(3.799923, 0.286107, -28.473690, 0.300910),
    vec4(1.624274, -0.832195, -39.535606, 0.270801),
    vec4(5.120192, -1.209738, -44.068203, 0.444526),
    vec4(3.897729, 0.254604, -7.239123, 0.423693),
    vec4(-1.667419, -0.751589, -4.597907, 0.376541),
    vec4(0.556300, -1.170042, -38.826420, 0.212812),
    vec4(-5.386286, 0.071628, -11.490047, 0.488022),
    vec4(-1.614267, -0.312636, -13.993090, 0.203696),
    vec4(3.541050, -1.246555, -18.844273, 0.277547),
    vec4(1.666533, 0.312097, -25.203678, 0.240634),
    vec4(1.001997, 0.181376, -45.268471, 0.523038),
    vec4(5.322481, -1.429790, -8.026159, 0.474554),
    vec4(4.122660, 0.388862, -18.571266, 0.291089),
    vec4(-4.790072, -0.631879, -20.253407, 0.446852),
    vec4(0.124258, -0.854451, -46.249638, 0.164063),
    vec4(-1.541849, -1.294674, -3.556623, 0.278679),
    vec4(4.316483, -1.364984, -7.999984, 0.293874),
    vec4(-0.259932, -0.204803, -41.249104, 0.466897),
    vec4(0.176856, -0.707660, -23.097353, 0.538299),
    vec4(3.605717, -0.578573, -3.917612, 0.344440),
    vec4(0.871424, -1.493175, -21.512264, 0.248533),
    vec4(5.821642, -0.088147, -39.063068, 0.400999),
    vec4(-5.352455, -0.103949, -11.571500, 0.545079),
    vec4(-0.570974, -0.420127, -34.632393, 0.352550),
    vec4(-2.015422, -1.165434, -19.199244, 0.379629),
    vec4(5.057647, -0.036170, -45.913372, 0.482086),
    vec4(-1.107771, -1.117859, -43.435699, 0.491985),
    vec4(-2.036961, -1.314767, -6.723235, 0.453955),
    vec4(0.320611, 0.267087, -32.737999, 0.436391),
    vec4(4.715811, -1.343897, -46.432091, 0.198927),
    vec4(3.239192, -0.389379, -37.159462, 0.543439));

// Returns the smallest t for which the point t * ray lies on a wall, the floor or the ceiling. Because ray.z is -1,
// t is the distance along -z.
float planes_hit(vec3 ray) {
    float t = min(60.0, 8.0 / abs(ray.x));
    if (ray.y < 0.0) t = min(t, -2.0 / ray.y);
    if (ray.y > 0.0) t = min(t, 6.0 / ray.y);
    return t;
}

// Returns the smaller root t of a t² + 2 b t + c = 0 if it is positive and below `otherwise`; else `otherwise`.
float first_root(float a, float b, float c, float otherwise) {
    const float root = b * b - a * c;
    if (root <= 0.0) return otherwise;
    const float t = (-b - sqrt(root)) / a;
    return t > 0.0 ? min(t, otherwise) : otherwise;
}

float columns_hit(vec3 ray, float t) {
    for (int i = 0; i < 24; ++i) {
        const vec2 axis = vec2((i & 1) == 0 ? -4.0 : 4.0, -4.0 - 4.0 * float(i / 2));
        t = first_root(dot(ray.xz, ray.xz), -dot(ray.xz, axis), dot(axis, axis) - 0.25, t);
    }
    return t;
}

void main() {
    const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(depth)))) return;
    const vec2 clip = (vec2(pixel) + 0.5) * view.inverse_viewport * 2.0 - 1.0;
    const vec3 ray = vec3(clip / vec2(view.projection[0].x, view.projection[1].y), -1.0);
    float t = columns_hit(ray, planes_hit(ray));
    for (int i = 0; i < kSpheres; ++i) {
        const vec4 s = kSphere[i];
        t = first_root(dot(ray, ray), -dot(ray, s.xyz), dot(s.xyz, s.xyz) - s.w * s.w, t);
    }
    imageStore(depth, pixel, vec4(view.near_m / t));
}
