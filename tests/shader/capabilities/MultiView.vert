// refused: the SPIR-V gate must reject this shader on every device.
#version 460
#extension GL_EXT_multiview : require
void main() {
    gl_Position = vec4(0, 0, 0, 1);
    gl_Position.x = float(gl_ViewIndex);  // expected error line
}
