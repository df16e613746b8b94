// refused: the SPIR-V gate must reject this shader on every device.
#version 460
#extension GL_AMD_shader_image_load_store_lod : require
layout(local_size_x = 8) in;
buffer Data { uint items[]; } data;
layout(rgba8) writeonly uniform image2D target;
void main() {
    imageStoreLodAMD(target, ivec2(0), 1, vec4(1));  // expected error line
}
