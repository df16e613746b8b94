// refused: the SPIR-V gate must reject this shader on every device.
#version 460
#extension GL_NV_compute_shader_derivatives : require
layout(local_size_x = 4) in;
buffer Data { uint items[]; } data;
layout(derivative_group_linearNV) in;  // expected error line
uniform sampler2D source;
void main() {
    data.items[0] = uint(texture(source, vec2(0.5)).x);
}
