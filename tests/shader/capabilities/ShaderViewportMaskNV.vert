// refused: the SPIR-V gate must reject this shader on every device.
#version 460
#extension GL_NV_viewport_array2 : require
void main() {
    gl_Position = vec4(0, 0, 0, 1);
    gl_ViewportMask[0] = 1;  // expected error line
}
