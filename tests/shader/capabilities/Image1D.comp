// interface: the SPIR-V gate and reflection must accept this shader and its variable on every device.
#version 460
layout(local_size_x = 8) in;
buffer Data { uint items[]; } data;
layout(rgba8) writeonly uniform image1D target;
void main() {
    imageStore(target, 0, vec4(1));
}
