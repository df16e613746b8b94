// refused: the SPIR-V gate must reject this shader on every device.
#version 460
layout(xfb_buffer = 0, xfb_offset = 0, location = 0) out vec4 copy;  // expected error line
void main() {
    gl_Position = vec4(0, 0, 0, 1);
    copy = vec4(1);
}
