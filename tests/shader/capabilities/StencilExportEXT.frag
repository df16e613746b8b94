// refused: the SPIR-V gate must reject this shader on every device.
#version 460
#extension GL_ARB_shader_stencil_export : require
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;
void main() {
    color = vec4(uv, 0, 1);
    gl_FragStencilRefARB = 1;  // expected error line
}
