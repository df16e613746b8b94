// refused: the SPIR-V gate must reject this shader on every device.
#version 460
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_buffer_reference_uvec2 : require
layout(local_size_x = 8) in;
buffer Data { uint items[]; } data;
layout(buffer_reference) buffer Anywhere { uint value; };  // expected error line
void main() {
    Anywhere(uvec2(data.items[0], data.items[1])).value = 1u;
}
