#version 460
#include "frame_set.glsl"
layout(local_size_x = 1) in;
layout(rgba32f) writeonly uniform image2D seen;
layout(push_constant) uniform Params {
    float preExposure;
    float prevPreExposure;
};

void main() {
    imageStore(seen, ivec2(0), vec4(frame.pre_exposure, frame.prev_pre_exposure, preExposure, prevPreExposure));
}
