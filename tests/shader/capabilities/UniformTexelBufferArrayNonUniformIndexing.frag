// refused: the SPIR-V gate must reject this shader on every device.
#version 460
#extension GL_EXT_nonuniform_qualifier : require
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;
uniform samplerBuffer source[2];
void main() {
    color = vec4(uv, 0, 1);
    color = texelFetch(source[nonuniformEXT(int(uv.x))], 0);  // expected error line
}
