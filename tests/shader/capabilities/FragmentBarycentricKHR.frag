// refused: the SPIR-V gate must reject this shader on every device.
#version 460
#extension GL_EXT_fragment_shader_barycentric : require
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;
void main() {
    color = vec4(uv, 0, 1);
    color.xyz = gl_BaryCoordEXT;  // expected error line
}
