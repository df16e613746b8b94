// allowed: the SPIR-V gate must accept this shader on every device.
#version 460
#extension GL_EXT_demote_to_helper_invocation : require
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;
void main() {
    color = vec4(uv, 0, 1);
    if (uv.x > 0.5) demote;
}
