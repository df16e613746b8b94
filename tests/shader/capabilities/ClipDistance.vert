// refused: the SPIR-V gate must reject this shader on every device.
#version 460
void main() {
    gl_Position = vec4(0, 0, 0, 1);
    gl_ClipDistance[0] = 1;  // expected error line
}
