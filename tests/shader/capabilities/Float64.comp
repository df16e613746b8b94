// refused: the SPIR-V gate must reject this shader on every device.
#version 460
layout(local_size_x = 8) in;
buffer Data { uint items[]; } data;
void main() {
    double sum = data.items[0];  // expected error line
    data.items[0] = uint(sum);
}
