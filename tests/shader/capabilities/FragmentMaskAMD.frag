// refused: the SPIR-V gate must reject this shader on every device.
#version 460
#extension GL_AMD_shader_fragment_mask : require
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;
uniform sampler2DMS source;
void main() {
    color = vec4(uv, 0, 1);
    color.x = float(fragmentMaskFetchAMD(source, ivec2(0)));  // expected error line
}
