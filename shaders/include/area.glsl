// Texture coordinates for images with a live size: only their area, the part at the top left, has content.
#ifndef WEFT_AREA
#define WEFT_AREA

// Converts `uv`, from 0 to 1 over the area, to a texture coordinate of the image. The result is clamped so that a
// linear filter reads only the area. `port_uv` and `port_uv_most` are the members <port>Uv and <port>UvMost of Params.
vec2 area_uv(vec2 uv, vec2 port_uv, vec2 port_uv_most) { return min(max(uv, vec2(0.0)) * port_uv, port_uv_most); }
#endif
