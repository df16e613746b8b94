#version 460
#extension GL_EXT_nonuniform_qualifier : require
layout(local_size_x = 8, local_size_y = 8) in;
uniform sampler2D materialTextures[];
layout(rgba16f) writeonly uniform image2D dst;
layout(push_constant) uniform Params { uint materialTexturesCount; } params;
void main() {
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    const uint number = uint(at.x) % params.materialTexturesCount;
    imageStore(dst, at, textureLod(materialTextures[nonuniformEXT(number)], vec2(0.5), 0.0));
}
