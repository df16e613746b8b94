// Draws a picture of two luminances, or of luminances that are spread over some stops, and some spoiled pixels.
#version 460
layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba16f) writeonly uniform image2D hdr;
layout(push_constant) uniform Params {
    float darkShare, dark, bright, stops, gain;
    uint spoiled, spoil;
    float preExposure;
} params;

// A hash with good avalanche: consecutive numbers give numbers without a visible pattern.
uint hash(uint x) {
    x = (x ^ (x >> 16)) * 0x7feb352du;
    x = (x ^ (x >> 15)) * 0x846ca68bu;
    return x ^ (x >> 16);
}

vec3 spoil() {
    const vec3 kinds[5] = vec3[](vec3(0.0), vec3(uintBitsToFloat(0x7fc00000u)), vec3(uintBitsToFloat(0x7f800000u)),
                                 vec3(-5.0, -2.0, -9.0), vec3(1e6 * params.preExposure));
    return kinds[params.spoil];
}

void main() {
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy), size = imageSize(hdr);
    if (any(greaterThanEqual(at, size))) return;
    const uint i = uint(at.y * size.x + at.x);
    float luminance = (float(i) + 0.5) / float(size.x * size.y) < params.darkShare ? params.dark : params.bright;
    if (params.stops > 0.0) luminance = params.dark * exp2(params.stops * float(hash(i)) / 4294967296.0);
    vec3 color = vec3(luminance * params.gain * params.preExposure);
    // The last pixels in the order of the picture are spoiled, so that bright pixels are replaced.
    if (i >= uint(size.x * size.y) - params.spoiled) color = spoil();
    imageStore(hdr, at, vec4(color, 1.0));
}
