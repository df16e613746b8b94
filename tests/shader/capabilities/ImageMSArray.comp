// refused: the SPIR-V gate must reject this shader on every device.
#version 460
layout(local_size_x = 8) in;
buffer Data { uint items[]; } data;
layout(rgba8) writeonly uniform image2DMSArray target;  // expected error line
void main() {
    imageStore(target, ivec3(0), 0, vec4(1));
}
