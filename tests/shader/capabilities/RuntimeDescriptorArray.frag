// tables: the SPIR-V gate accepts this shader. resolve() checks that the device has tables of textures.
#version 460
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;
#extension GL_EXT_nonuniform_qualifier : require
uniform sampler2D source[];
void main() {
    color = vec4(uv, 0, 1);
    color = texture(source[int(uv.x)], uv);
}
