#version 460
layout(local_size_x = 1) in;
layout(push_constant) uniform Params { uint beforeValid; uint olderValid; } params;
uniform usampler2D now, before, older;
writeonly buffer Seen { uint words[]; } seen;

void main() {
    seen.words[0] = texelFetch(now, ivec2(3, 1), 0).r;
    seen.words[1] = texelFetch(before, ivec2(3, 1), 0).r;
    seen.words[2] = texelFetch(older, ivec2(3, 1), 0).r;
    seen.words[3] = texelFetch(now, ivec2(3, 6), 0).r;
    seen.words[4] = texelFetch(now, ivec2(1, 1), 1).r;
    seen.words[5] = params.beforeValid;
    seen.words[6] = params.olderValid;
    seen.words[7] = 0u;
}
