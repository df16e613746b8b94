// A vertex of a drawn surface, in the canonical vertex format: a position stream and an attribute stream. What every
// fragment stage wants to know is handed on at locations 0 to 2.
#include "shared/instance.glsl"

layout(location = 0) in vec4 position;
layout(location = 1) in vec4 normal;
layout(location = 2) in vec4 tangent;
layout(location = 3) in vec2 uv;

layout(set = 3, binding = 0, std430) readonly buffer Instances { Instance instances[]; };

layout(location = 0) out vec3 world_normal;
layout(location = 1) out vec4 world_tangent;
layout(location = 2) out vec2 surface_uv;

Instance place_surface() {
    const Instance instance = instances[gl_InstanceIndex];
    world_normal = mat3(instance.normal_to_world) * normal.xyz;
    world_tangent = vec4(mat3(instance.object_to_world) * tangent.xyz, tangent.w);
    surface_uv = uv;
    return instance;
}
