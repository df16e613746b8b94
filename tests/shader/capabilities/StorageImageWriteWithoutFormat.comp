// allowed: the SPIR-V gate must accept this shader on every device.
#version 460
layout(local_size_x = 8) in;
buffer Data { uint items[]; } data;
writeonly uniform image2D target;
void main() {
    imageStore(target, ivec2(0), vec4(1));
}
