#version 460
#include "frame_set.glsl"
#include "two_skies.glsl"
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 backbuffer;
layout(push_constant) uniform Params { float gain; } params;
uniform sampler2D by_push;
uniform sampler2D by_block;
uniform sampler2D by_frame;
uniform sampler2D by_view;
uniform sampler2D by_port;

void main() {
    backbuffer = two_skies(frame.time_s < 1e6, uv) * params.gain;
    backbuffer += texture(by_push, uv) + texture(by_block, uv) + texture(by_frame, uv) + texture(by_view, uv) +
                  texture(by_port, uv);
}
