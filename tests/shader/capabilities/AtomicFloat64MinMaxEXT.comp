// refused: the SPIR-V gate must reject this shader on every device.
#version 460
#extension GL_EXT_shader_atomic_float2 : require
layout(local_size_x = 8) in;
buffer Data { uint items[]; } data;
buffer Sums { double sum; } sums;  // expected error line
void main() {
    atomicMax(sums.sum, 1.0lf);
}
