// refused: the SPIR-V gate must reject this shader on every device.
#version 460
#extension GL_AMD_gpu_shader_half_float : require
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;
layout(location = 1) in float16_t narrow;  // expected error line
void main() {
    color = vec4(uv, 0, 1);
    color.x = float(narrow);
}
