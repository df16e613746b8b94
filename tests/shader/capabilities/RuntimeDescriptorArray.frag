// refused: the SPIR-V gate must reject this shader on every device.
#version 460
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;
#extension GL_EXT_nonuniform_qualifier : require  // expected error line
uniform sampler2D source[];
void main() {
    color = vec4(uv, 0, 1);
    color = texture(source[int(uv.x)], uv);
}
