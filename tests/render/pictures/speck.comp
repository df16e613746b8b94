// Draws one bright texel in the middle of a uniform dim picture.
#version 460
layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba16f) writeonly uniform image2D hdr;
layout(push_constant) uniform Params { float speck; float everywhere; } params;
void main() {
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy), size = imageSize(hdr);
    if (any(greaterThanEqual(at, size))) return;
    const float value = params.everywhere + (at == size / 2 ? params.speck : 0.0);
    imageStore(hdr, at, vec4(value, value * 0.5, value * 2.0, 1.0));
}
