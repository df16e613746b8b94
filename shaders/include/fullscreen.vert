#version 460

// One triangle that covers the target, computed from the vertex index alone. uv is (0,0) at the top left
// corner of row 0 and (1,1) at the bottom right, because in Vulkan's viewport y points down. The corners are
// in counter-clockwise order, so back-face culling keeps the triangle. Depth is 0: the far plane with
// reversed Z.
layout(location = 0) out vec2 uv;

void main() {
    vec2 corner = vec2((gl_VertexIndex & 2) != 0 ? 3.0 : -1.0, (gl_VertexIndex & 1) != 0 ? 3.0 : -1.0);
    uv = 0.5 * corner + 0.5;
    gl_Position = vec4(corner, 0.0, 1.0);
}
