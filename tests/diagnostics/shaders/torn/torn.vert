#version 460
layout(location = 0) in vec3 position;
layout(location = 0) out vec3 shade;

void main() {
    shade = position;
    gl_Position = vec4(position * 0.1, 1);
}
