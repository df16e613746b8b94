#version 460
layout(constant_id = 1) const uint FLIPPED = 0;
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 backbuffer;
layout(push_constant) uniform Params { float gain; } params;
uniform sampler2D paint;
uniform sampler2D trail;

void main() {
    const vec2 at = FLIPPED != 0 ? uv.yx : uv;
    backbuffer = vec4(texture(paint, at).rgb * params.gain * texture(trail, uv).r, 1);
}
