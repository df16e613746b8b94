// refused: the SPIR-V gate must reject this shader on every device.
#version 460
#extension GL_EXT_ray_query : require
layout(local_size_x = 8) in;
buffer Data { uint items[]; } data;
uniform accelerationStructureEXT world;  // expected error line
void main() {
    rayQueryEXT query;
    rayQueryInitializeEXT(query, world, 0, 255, vec3(0), 0.0, vec3(1), 1.0);
}
