// device: the SPIR-V gate must accept this shader only if the device supports StorageImageReadWithoutFormat.
#version 460
#extension GL_EXT_shader_image_load_formatted : require
layout(local_size_x = 8) in;
buffer Data { uint items[]; } data;
readonly uniform image2D source;
void main() {
    data.items[0] = uint(imageLoad(source, ivec2(0)).x);  // expected error line
}
