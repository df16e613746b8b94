#version 460
layout(local_size_x = 1) in;
layout(push_constant) uniform Params { uint bakedValidBits; float bakedValid; uint markedValidBits; uint bouncedValidBits; } params;
uniform sampler2DArray baked;
uniform sampler2DArray marked;
uniform sampler2DArray bounced;
layout(std430) writeonly buffer seen_buffer { uint words[]; } seen;

void main() {
    // The reads keep the ports in use.
    const float sum = texelFetch(baked, ivec3(0), 0).x + texelFetch(marked, ivec3(0), 0).x + texelFetch(bounced, ivec3(0), 0).x;
    seen.words[0] = params.bakedValidBits;
    seen.words[1] = uint(params.bakedValid);
    seen.words[2] = params.markedValidBits;
    seen.words[3] = params.bouncedValidBits + (sum < -1.0 ? 16 : 0);
}
