// The image `lightBounds`: five texels for each light, one below the other in a column, and 256 lights in a row. The first
// is a sphere in view space around what the light reaches (centre, radius, in metres); the others are a Reach. An image,
// because some devices gather from images faster than from buffers.

const uint kLightsPerRow = 256;
const uint kTexelsPerLight = 5;

ivec2 bounds_texel(uint light) {
    return ivec2(light % kLightsPerRow, light / kLightsPerRow * kTexelsPerLight);
}
