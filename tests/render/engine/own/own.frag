#version 460
layout(set = 2, binding = 0, std140) uniform Paint { vec4 tint; } paint_of_list;
layout(location = 0) out vec4 color;

void main() { color = paint_of_list.tint; }
