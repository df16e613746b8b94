// Writes the position of the pixel in the world, and its position in the previous frame.
#version 460
layout(location = 0) in vec3 world;
layout(location = 1) in vec3 before;
layout(location = 0) out vec4 place;
layout(location = 1) out vec4 past;

void main() {
    place = vec4(world, 1);
    past = vec4(before, 1);
}
