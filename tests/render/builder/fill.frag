#version 460
layout(location = 0) out vec4 color;
layout(push_constant) uniform Params { float red; } params;

void main() {
    color = vec4(params.red, gl_FragCoord.xy / 256.0, 1.0);
}
