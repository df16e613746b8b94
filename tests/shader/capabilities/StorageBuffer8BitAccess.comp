// refused: the SPIR-V gate must reject this shader on every device.
#version 460
#extension GL_EXT_shader_8bit_storage : require
layout(local_size_x = 8) in;
buffer Data { uint items[]; } data;
buffer Bytes { uint8_t byte; } bytes;  // expected error line
void main() {
    data.items[0] = uint(bytes.byte);
}
