// Arranges the layers of an image on a sheet, for debug views: the layers of one probe side by side, and the probes from
// left to right and from top to bottom.
#include "debug_colors.glsl"
#include "srgb.glsl"

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;

uniform sampler2DArray shown;

layout(push_constant) uniform Params { vec2 colorSize; } params;

// Returns the content at a pixel. `exists` is false between the probes and after the last one.
vec4 sheet_value(int layers_of_probe, out bool exists) {
    const ivec3 size = textureSize(shown, 0);
    const int probes = max(size.z / layers_of_probe, 1);
    // Chooses the number of columns with which the layers are largest.
    float side_px = 0.0;
    int columns = 1;
    for (int wanted = 1; wanted <= probes; ++wanted) {
        const float rows = float((probes + wanted - 1) / wanted);
        const float fits_px = min(params.colorSize.x / float(wanted * layers_of_probe), params.colorSize.y / rows);
        if (fits_px > side_px) columns = wanted;
        side_px = max(side_px, fits_px);
    }
    const vec2 at = uv * params.colorSize / side_px;
    const int column = int(at.x) / layers_of_probe;
    const ivec3 place = ivec3(column, int(at.y), int(at.x) % layers_of_probe);
    const int layer = (place.y * columns + place.x) * layers_of_probe + place.z;
    const vec2 from_edge_px = vec2(at.x - float(column * layers_of_probe), fract(at.y)) * side_px;
    exists = column < columns && layer < size.z && min(from_edge_px.x, from_edge_px.y) >= 1.0;
    return texelFetch(shown, ivec3(fract(at) * vec2(size.xy), min(layer, size.z - 1)), 0);
}
