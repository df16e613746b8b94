// refused: the SPIR-V gate must reject this shader on every device.
#version 460
layout(local_size_x = 8) in;
buffer Data { uint items[]; } data;
layout(rgba8) writeonly uniform imageBuffer target[2];  // expected error line
void main() {
    imageStore(target[data.items[0]], 0, vec4(1));
}
