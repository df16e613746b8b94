// Functions that return the colours of debug views.
#ifndef WEFT_DEBUG_COLORS
#define WEFT_DEBUG_COLORS

// Returns dark stripes, for pixels where nothing was drawn. No value is shown with such stripes.
vec3 nothing_color(ivec2 pixel) { return ((pixel.x + pixel.y) >> 2 & 1) == 0 ? vec3(0.09, 0.1, 0.13) : vec3(0.17, 0.18, 0.22); }

// Returns a colour for x from 0 to 1: black, indigo, magenta, orange, pale yellow. A larger x has a brighter colour.
vec3 heat_color(float x) {
    const vec3 stops[5] =
        vec3[](vec3(0.0, 0.0, 0.02), vec3(0.23, 0.1, 0.5), vec3(0.75, 0.2, 0.45), vec3(0.98, 0.6, 0.2), vec3(1.0, 1.0, 0.75));
    const float at = clamp(x, 0.0, 1.0) * 4.0;
    const int i = min(int(at), 3);
    return mix(stops[i], stops[i + 1], at - float(i));
}

// Returns a colour for a number. Neighbouring numbers have clearly different colours; distant numbers can have nearly
// the same colour. 0 is black.
vec3 index_color(uint index) {
    if (index == 0u) return vec3(0.0);
    const float hue = fract(float(index & 0xFFFFu) * 0.61803399);  // The golden ratio distributes the hues evenly.
    const vec3 wheel = clamp(abs(fract(hue + vec3(0.0, 2.0, 1.0) / 3.0) * 6.0 - 3.0) - 1.0, 0.0, 1.0);
    return mix(vec3(0.45), wheel, 0.7) * ((index & 1u) == 1u ? 1.0 : 0.75);
}

// Returns a colour for a vector: the direction gives the hue, the length (up to 1) gives the brightness.
vec3 vector_color(vec2 v) {
    const float amount = length(v);
    if (amount == 0.0) return vec3(0.0);
    const float hue = atan(v.y, v.x) / 6.2831853;
    const vec3 wheel = clamp(abs(fract(hue + vec3(0.0, 2.0, 1.0) / 3.0) * 6.0 - 3.0) - 1.0, 0.0, 1.0);
    return wheel * min(amount, 1.0);
}
#endif
