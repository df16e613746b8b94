// Writes the results of tiles in which nothing reflects: no rays, no light, and the shape of the surfaces. See
// temporal.comp for the layers of ssr.
#version 460
#include "frame_set.glsl"
#include "octahedral.glsl"
#include "tiles.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(std430) readonly buffer Tiles { uint items[]; } tiles;
uniform sampler2D ssrSurface;
layout(rgba16f) writeonly uniform image2DArray ssr;
layout(rgba16f) writeonly uniform image2D ssrMean;
layout(rgba16f) writeonly uniform image2DArray ssrLight;
layout(r16f) writeonly uniform image2D ssrReach;

layout(push_constant) uniform Params {
    uint ssrScale;
} params;

void main() {
    const uint at = place_in_list();
    if (at >= tiles.items[3]) return;
    const ivec2 size = imageSize(ssr).xy;
    const ivec2 texel = texel_of_tile(tiles.items[kTilesBegin + at], size);
    if (any(greaterThanEqual(texel, size))) return;
    const vec4 surface = texelFetch(ssrSurface, texel, 0);
    const vec2 uv = (vec2(texel * int(params.ssrScale)) + 0.5) * view.inverse_viewport;
    vec4 shape = vec4(0.0);
    if (surface.z > 0.0) shape = vec4(surface.xy, min(distance(world_position(uv, surface.z), view.eye), 65000.0), -1.0);
    imageStore(ssr, ivec3(texel, 0), vec4(0.0));
    imageStore(ssr, ivec3(texel, 1), shape);
    imageStore(ssr, ivec3(texel, 2), vec4(0.0));
    imageStore(ssrMean, texel, vec4(0.0));
    imageStore(ssrReach, texel, vec4(0.0));
    for (int i = 0; i < imageSize(ssrLight).z; ++i) imageStore(ssrLight, ivec3(texel, i), vec4(0.0));
}
