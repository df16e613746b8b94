// refused: the SPIR-V gate must reject this shader on every device.
#version 460
#extension GL_ARB_sparse_texture_clamp : require
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;
uniform sampler2D source;
void main() {
    color = vec4(uv, 0, 1);
    color = textureClampARB(source, uv, 1.0);  // expected error line
}
