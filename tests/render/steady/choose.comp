#version 460
layout(local_size_x = 1) in;
layout(push_constant) uniform Params { uint frameIndex; } params;
writeonly buffer Choice { uint items[]; } choice;

void main() {
    for (uint i = 0u; i < 4u; ++i) choice.items[i] = params.frameIndex * i;
}
