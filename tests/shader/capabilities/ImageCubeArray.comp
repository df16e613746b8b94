// device: the SPIR-V gate must accept this shader only if the device supports ImageCubeArray.
#version 460
layout(local_size_x = 8) in;
buffer Data { uint items[]; } data;
layout(rgba8) writeonly uniform imageCubeArray target;  // expected error line
void main() {
    imageStore(target, ivec3(0), vec4(1));
}
