// interface
#version 460
layout(local_size_x = 8) in;
buffer Data { uint items[]; } data;
layout(rgba8) writeonly uniform image1D target;
void main() {
    imageStore(target, 0, vec4(1));
}
