// refused: the SPIR-V gate must reject this shader on every device.
#version 460
#extension GL_ARB_fragment_shader_interlock : require
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;
layout(pixel_interlock_ordered) in;  // expected error line
void main() {
    color = vec4(uv, 0, 1);
    beginInvocationInterlockARB();
    endInvocationInterlockARB();
}
