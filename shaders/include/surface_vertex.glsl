// Reads a vertex of a drawn surface in the standard vertex format: a stream of positions, a stream of attributes, and
// buffers for colours and second uvs, which only some meshes have. Writes the outputs for the fragment stage at
// locations 0 to 4.
#ifndef WEFT_SURFACE_VERTEX
#define WEFT_SURFACE_VERTEX
#include "shared/instance.glsl"

layout(location = 0) in vec4 position;
layout(location = 1) in vec4 normal;
layout(location = 2) in vec4 tangent;
layout(location = 3) in vec2 uv;

layout(set = 3, binding = 0, std430) readonly buffer Instances { Instance instances[]; };
layout(set = 3, binding = 1, std430) readonly buffer VertexColors { uvec2 vertex_colors[]; };  // Format rgba16 unorm.
layout(set = 3, binding = 2, std430) readonly buffer SecondUvs { vec2 second_uvs[]; };

// With this declaration, all passes compute exactly the same depth for the same surface, so that a later pass can test
// for equal depth.
invariant gl_Position;

layout(location = 0) out vec3 world_normal;
layout(location = 1) out vec4 world_tangent;
layout(location = 2) out vec2 surface_uv;
layout(location = 3) out vec2 surface_second_uv;
// 1 − vertex colour. Without vertex colours this is 0, and the interpolation of zeros is exact.
layout(location = 4) out vec4 color_lack;

Instance place_surface() {
    const Instance instance = instances[gl_InstanceIndex];
    world_normal = mat3(instance.normal_to_world) * normal.xyz;
    world_tangent = vec4(mat3(instance.object_to_world) * tangent.xyz, tangent.w);
    surface_uv = uv;
    surface_second_uv = uv;
    if (instance.second_uv_offset != kNoStream)
        surface_second_uv = second_uvs[gl_VertexIndex + instance.second_uv_offset];
    color_lack = vec4(0.0);
    if (instance.color_offset != kNoStream) {
        const uvec2 color = vertex_colors[gl_VertexIndex + instance.color_offset];
        color_lack = 1.0 - vec4(unpackUnorm2x16(color.x), unpackUnorm2x16(color.y));
    }
    return instance;
}
#endif
