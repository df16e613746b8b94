// Copies memory for `weft bench frame`: each invocation reads and writes 16 bytes.
#version 460

layout(local_size_x = 256) in;

layout(std430) readonly buffer Source { uvec4 items[]; } source;
layout(std430) writeonly buffer Copied { uvec4 items[]; } copied;

void main() {
    const uint i = gl_GlobalInvocationID.x;
    if (i < uint(copied.items.length())) copied.items[i] = source.items[i];
}
