// refused: the SPIR-V gate must reject this shader on every device.
#version 460
#extension GL_NV_stereo_view_rendering : require
void main() {
    gl_Position = vec4(0, 0, 0, 1);
    gl_SecondaryPositionNV = vec4(1);  // expected error line
}
