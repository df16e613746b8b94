#version 460
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 disc;
layout(push_constant) uniform Params { float radius; } params;

void main() {
    disc = distance(uv, vec2(0.5)) < params.radius ? vec4(1, 0.5, 0, 1) : vec4(0, 0, 0.25, 1);
}
