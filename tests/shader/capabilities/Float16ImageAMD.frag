// refused: the SPIR-V gate must reject this shader on every device.
#version 460
#extension GL_EXT_shader_explicit_arithmetic_types_float16 : require
#extension GL_AMD_gpu_shader_half_float_fetch : require
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;
uniform f16sampler2D source;  // expected error line
void main() {
    color = vec4(uv, 0, 1);
    color = vec4(texture(source, uv));
}
