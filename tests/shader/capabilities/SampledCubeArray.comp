// device: the SPIR-V gate must accept this shader only if the device supports SampledCubeArray.
#version 460
layout(local_size_x = 8) in;
buffer Data { uint items[]; } data;
uniform samplerCubeArray source;  // expected error line
void main() {
    data.items[0] = uint(textureLod(source, vec4(1), 0).x);
}
