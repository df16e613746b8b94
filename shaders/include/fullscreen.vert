#version 460

// Draws one triangle that covers the whole target. The corners follow from the vertex index, so no vertex buffer is
// needed. uv is (0,0) at the top left and (1,1) at the bottom right, because y points down in Vulkan's viewport. The
// corners are counter-clockwise, so that back-face culling keeps the triangle. Depth is 0, the far plane of reversed
// depth.
layout(location = 0) out vec2 uv;

void main() {
    vec2 corner = vec2((gl_VertexIndex & 2) != 0 ? 3.0 : -1.0, (gl_VertexIndex & 1) != 0 ? 3.0 : -1.0);
    uv = 0.5 * corner + 0.5;
    gl_Position = vec4(corner, 0.0, 1.0);
}
