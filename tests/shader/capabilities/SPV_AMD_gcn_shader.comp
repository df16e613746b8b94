// refused: the SPIR-V gate must reject this shader on every device.
#version 460
layout(local_size_x = 8) in;
buffer Data { uint items[]; } data;
#extension GL_AMD_gcn_shader : require  // expected error line
void main() {
    data.items[0] = uint(cubeFaceIndexAMD(vec3(1)));
}
