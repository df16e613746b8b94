// refused: the SPIR-V gate must reject this shader on every device.
#version 460
#extension GL_EXT_null_initializer : require
layout(local_size_x = 8) in;
buffer Data { uint items[]; } data;
shared uint total = { };  // expected error line
void main() {
    total += 1u;
    data.items[0] = total;
}
