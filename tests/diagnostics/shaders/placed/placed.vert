#version 460
void main() {
    const vec2 corner = vec2(gl_VertexIndex & 1, gl_VertexIndex >> 1) * 2.0 - 1.0;
    gl_Position = vec4(corner / float(gl_InstanceIndex + 1), 0.0, 1.0);
}
