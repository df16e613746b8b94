// refused: the SPIR-V gate must reject this shader on every device.
#version 460
#extension GL_ARB_post_depth_coverage : require
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;
layout(early_fragment_tests) in;
layout(post_depth_coverage) in;  // expected error line
void main() {
    color = vec4(uv, 0, 1);
}
