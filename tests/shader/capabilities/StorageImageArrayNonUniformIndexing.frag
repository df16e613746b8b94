// refused: the SPIR-V gate must reject this shader on every device.
#version 460
#extension GL_EXT_nonuniform_qualifier : require
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;
layout(rgba8) readonly uniform image2D source[2];
void main() {
    color = vec4(uv, 0, 1);
    color = imageLoad(source[nonuniformEXT(int(uv.x))], ivec2(0));  // expected error line
}
