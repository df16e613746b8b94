#version 460
layout(local_size_x = 8, local_size_y = 8) in;
writeonly uniform image2D image;
layout(push_constant) uniform Settings { float amount; } settings;
//                            ^ W206 is expected here

void main() { imageStore(image, ivec2(gl_GlobalInvocationID.xy), vec4(settings.amount)); }
