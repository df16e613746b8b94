// refused: the SPIR-V gate must reject this shader on every device.
#version 460
#extension GL_NV_shader_texture_footprint : require
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;
uniform sampler2D source;
void main() {
    color = vec4(uv, 0, 1);
    gl_TextureFootprint2DNV footprint;
    color.x = float(textureFootprintNV(source, uv, 2, true, footprint));  // expected error line
}
