// refused: the SPIR-V gate must reject this shader on every device.
#version 460
#extension GL_NV_sample_mask_override_coverage : require
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;
layout(override_coverage) out int gl_SampleMask[];  // expected error line
void main() {
    color = vec4(uv, 0, 1);
    gl_SampleMask[0] = 1;
}
