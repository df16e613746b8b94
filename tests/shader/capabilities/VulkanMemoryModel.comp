// refused: the SPIR-V gate must reject this shader on every device.
#version 460
layout(local_size_x = 8) in;
buffer Data { uint items[]; } data;
#pragma use_vulkan_memory_model  // The error must name this line: // error here
void main() {
    data.items[0] = 1u;
}
