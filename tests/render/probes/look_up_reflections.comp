// Looks up the reflections of rays in a room. Row 0: rgb radiance and share. Row 1: the direction in which the cube is
// read, and how well the probe sees the end of the ray.
#version 460
#include "reflection_probes.glsl"

layout(local_size_x = 8) in;

layout(rgba32f) writeonly uniform image2D found;

struct Ray { vec3 position, direction; };
const Ray kRays[8] = Ray[8](
    Ray(vec3(3.0, 0.0, -2.0), vec3(1.0, 2.0, -1.0)), Ray(vec3(3.0, 0.0, -2.0), vec3(-3.0, 1.0, 2.0)),
    Ray(vec3(-4.0, 0.0, 4.0), vec3(2.0, 1.0, -4.0)), Ray(vec3(-4.0, 1.0, 4.0), vec3(-1.0, 1.0, 1.0)),
    Ray(vec3(0.0, 2.0, 1.0), vec3(1.0, 1.0, 1.0)),   Ray(vec3(4.5, 5.0, -4.5), vec3(-5.0, -3.0, 4.0)),
    Ray(vec3(1.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0)),   Ray(vec3(-2.0, 3.0, 2.0), vec3(2.0, -1.0, -2.0)));

void main() {
    const int at = int(gl_GlobalInvocationID.x);
    if (at >= 8) return;
    const vec3 position = kRays[at].position, direction = normalize(kRays[at].direction);
    const ReflectionLight light = reflection_light(position, direction, 0.0, 0.0);
    imageStore(found, ivec2(at, 0), vec4(light.radiance, light.share));
    float agreement = 1.0;
    const vec3 way = has_reflection_box(0u)
                         ? boxed_reflection(0u, position, direction)
                         : followed_reflection(0u, position - reflection_place(0u), direction, agreement);
    imageStore(found, ivec2(at, 1), vec4(normalize(way), agreement));
}
