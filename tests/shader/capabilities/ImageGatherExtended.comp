// device: the SPIR-V gate must accept this shader only if the device supports ImageGatherExtended.
#version 460
layout(local_size_x = 8) in;
buffer Data { uint items[]; } data;
uniform sampler2D source;
void main() {
    data.items[0] = uint(textureGatherOffset(source, vec2(0.5), ivec2(data.items[1])).x);  // expected error line
}
