// refused: the SPIR-V gate must reject this shader on every device.
#version 460
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;
layout(input_attachment_index = 0) uniform subpassInput source[2];
void main() {
    color = vec4(uv, 0, 1);
    color = subpassLoad(source[int(uv.x)]);  // expected error line
}
