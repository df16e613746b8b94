#version 460
layout(location = 0) in vec2 uv;
uniform sampler2D table, place, outline;
uniform sampler2DArray smooth_;
layout(location = 0) out vec4 color;

void main() {
    color = texture(outline, uv) + texture(table, uv) + texture(place, uv) + texture(smooth_, vec3(uv, 0)) +
            texture(smooth_, vec3(uv, 1));
}
