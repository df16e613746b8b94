#version 460
layout(location = 0) out uint value;

void main() { value = 100u; }
