// The image `lightBounds`: five texels per light, stored vertically, with 256 lights in a row. The first
// texel is a bounding sphere in view space (centre, radius, in metres); the others are a Reach. It is an
// image, because some devices gather from images faster than from buffers.

const uint kLightsPerRow = 256;
const uint kTexelsPerLight = 5;

ivec2 bounds_texel(uint light) {
    return ivec2(light % kLightsPerRow, light / kLightsPerRow * kTexelsPerLight);
}
