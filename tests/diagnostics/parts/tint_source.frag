#version 460
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 picture;
uniform sampler2D source;
layout(push_constant) uniform Params { float amount, green; } params;

void main() { picture = mix(texture(source, uv), vec4(0, params.green, 0, 1), params.amount); }
