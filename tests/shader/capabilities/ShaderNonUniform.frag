// tables: the SPIR-V gate accepts this shader. resolve() checks that the device has tables of textures.
#version 460
#extension GL_EXT_nonuniform_qualifier : require
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;
uniform sampler2D source[4];
void main() {
    color = vec4(uv, 0, 1);
    color = texture(source[nonuniformEXT(int(uv.x))], uv);
}
