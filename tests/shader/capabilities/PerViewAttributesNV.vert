// refused: the SPIR-V gate must reject this shader on every device.
#version 460
#extension GL_NVX_multiview_per_view_attributes : require
void main() {
    gl_Position = vec4(0, 0, 0, 1);
    gl_PositionPerViewNV[0] = vec4(1);  // expected error line
}
