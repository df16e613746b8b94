#version 460
layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 0) const bool HAS_around = false;
layout(constant_id = 1) const bool HAS_maps = false;
uniform samplerCubeArray around;
uniform sampler2DArray maps;
uniform writeonly image2D backbuffer;

void main() {
    vec4 color = vec4(0.5);
    if (HAS_around) color += textureLod(around, vec4(1.0), 0.0);
    if (HAS_maps) color += textureLod(maps, vec3(0.5), 0.0);
    imageStore(backbuffer, ivec2(gl_GlobalInvocationID.xy), color);
}
