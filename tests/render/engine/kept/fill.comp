#version 460
layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f) writeonly uniform image2DArray table;
layout(push_constant) uniform Params { float weight; } params;

void main() {
    const ivec3 at = ivec3(gl_GlobalInvocationID);
    if (any(greaterThanEqual(at, imageSize(table)))) return;
    imageStore(table, at, vec4(params.weight, at));
}
