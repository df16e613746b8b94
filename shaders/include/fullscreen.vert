#version 460

// One triangle that covers the target, made from the vertex index alone. uv is (0,0) at the top left corner of
// row 0 and (1,1) at the bottom right, because the viewport is Vulkan's own: y points down.
// The order of the corners is counter-clockwise, so the triangle survives back-face culling.
// Depth is 0: the far plane under reversed Z.
layout(location = 0) out vec2 uv;

void main() {
    vec2 corner = vec2((gl_VertexIndex & 2) != 0 ? 3.0 : -1.0, (gl_VertexIndex & 1) != 0 ? 3.0 : -1.0);
    uv = 0.5 * corner + 0.5;
    gl_Position = vec4(corner, 0.0, 1.0);
}
