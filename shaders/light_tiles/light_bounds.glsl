// Layout of the image `lightBounds`: five texels per light, one below the other, and 256 lights in a row. The first
// texel is a bounding sphere in view space (centre and radius, in metres); the other four are a Reach (reach.glsl). The
// data is in an image, because some devices gather from images faster than from buffers.

const uint kLightsPerRow = 256;
const uint kTexelsPerLight = 5;

ivec2 bounds_texel(uint light) {
    return ivec2(light % kLightsPerRow, light / kLightsPerRow * kTexelsPerLight);
}
