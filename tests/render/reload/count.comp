#version 460
layout(local_size_x = 1) in;
buffer Frames { uint number; } frames;

void main() {
    frames.number += 1;
}
