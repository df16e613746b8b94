// refused: the SPIR-V gate must reject this shader on every device.
#version 460
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;
#extension GL_AMD_shader_explicit_vertex_parameter : require  // expected error line
void main() {
    color = vec4(uv, 0, 1);
    color.xy = gl_BaryCoordNoPerspAMD;
}
