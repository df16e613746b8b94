// interface: reflection must reject this shader, because no pass can bind its variable.
#version 460
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;
layout(input_attachment_index = 0) uniform subpassInput source;  // expected error line
void main() {
    color = vec4(uv, 0, 1);
    color = subpassLoad(source);
}
