// refused: the SPIR-V gate must reject this shader on every device.
#version 460
layout(local_size_x = 8) in;
buffer Data { uint items[]; } data;
#pragma use_variable_pointers  // expected error line
void main() {
    data.items[0] = 1u;
}
