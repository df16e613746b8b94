// refused: the SPIR-V gate must reject this shader on every device.
#version 460
#extension GL_INTEL_shader_integer_functions2 : require
layout(local_size_x = 8) in;
buffer Data { uint items[]; } data;
void main() {
    data.items[0] = absoluteDifference(data.items[0], 5u);  // expected error line
}
