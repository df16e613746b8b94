// allowed: the SPIR-V gate must accept this shader on every device.
#version 460
#extension GL_EXT_debug_printf : require
layout(local_size_x = 8) in;
buffer Data { uint items[]; } data;
void main() {
    debugPrintfEXT("%d", 1);
    data.items[0] = 1u;
}
