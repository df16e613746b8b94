// Draws a legend into the lower left corner of a debug view. The legend shows the values of some colours. Pictures
// smaller than 160 × 90 pixels get no legend.
#ifndef WEFT_DEBUG_LEGEND
#define WEFT_DEBUG_LEGEND
#include "debug_colors.glsl"
#include "debug_digits.glsl"

// Indices into debug_decoders() in C++.
const uint kDepth = 5u, kVector = 6u, kFirstChannel = 7u, kHeat = 11u;

const ivec2 kBar = ivec2(120, 8), kBarPanel = kBar + ivec2(8, 14);
const int kWheelRadius = 18;
const ivec2 kWheelPanel = ivec2(2 * kWheelRadius + 9, 2 * kWheelRadius + 18);

float number_at(float part, uint decode, float black, float white) {
    const float number = mix(black, white, part);
    return decode == kDepth ? exp2(number) - 1.0 : number;
}

vec3 bar_color(float part, uint decode) {
    return decode == kHeat ? heat_color(part) : vec3(decode == kDepth ? 1.0 - part : part);
}

// Returns true if the pixel is part of the letter m, which is drawn after a number as the unit (metres).
bool is_unit(ivec2 at) {
    const uint rows[5] = uint[](0x00u, 0x1Au, 0x15u, 0x15u, 0x15u);
    return all(greaterThanEqual(at, ivec2(0))) && all(lessThan(at, ivec2(5))) && (rows[at.y] >> (4 - at.x) & 1u) == 1u;
}

// Returns true if the pixel is part of the label: a number centred at `center`, moved if it would leave the bar.
bool is_label(float number, int center, bool metres, ivec2 at) {
    const int width = decimal_width(number), all_width = width + (metres ? 6 : 0);
    const ivec2 from = ivec2(clamp(center - all_width / 2, 0, kBar.x - all_width), 0);
    return is_decimal(number, at - from) || metres && is_unit(at - from - ivec2(width, 0));
}

vec3 bar_legend(ivec2 at, uint decode, float black, float white) {
    for (int i = 0; i < 3; ++i) {
        const int center = i * (kBar.x - 1) / 2;
        const float number = number_at(float(i) * 0.5, decode, black, white);
        if (is_label(number, center, decode == kDepth, at - ivec2(4, 3)) || at.x == center + 4 && at.y == 9) return vec3(1.0);
    }
    const ivec2 on_bar = at - ivec2(4, 10);
    const bool inside = all(greaterThanEqual(on_bar, ivec2(0))) && all(lessThan(on_bar, kBar));
    return inside ? bar_color(float(on_bar.x) / float(kBar.x - 1), decode) : vec3(0.0);
}

// Returns the legend of vectors: a wheel with the colour of each direction. The number below the wheel is the vector
// length that has full brightness.
vec3 wheel_legend(ivec2 at, float white) {
    const vec2 v = vec2(at - ivec2(kWheelRadius + 4)) / float(kWheelRadius);
    if (dot(v, v) <= 1.0) return vector_color(v);
    const int left = (kWheelPanel.x - decimal_width(white)) / 2;
    return vec3(is_decimal(white, at - ivec2(left, 2 * kWheelRadius + 10)) ? 1.0 : 0.0);
}

// `size_px` is the size of the debug view.
vec3 with_legend(vec3 color, uint decode, float black, float white, vec2 size_px) {
    const bool wheel = decode == kVector, bar = decode == kDepth || decode >= kFirstChannel && decode <= kHeat;
    const ivec2 size = ivec2(size_px);
    if (!wheel && !bar || size.x < 160 || size.y < 90) return color;
    const int scale = max(1, size.y / 360), margin = 6 * scale;
    const ivec2 panel = wheel ? kWheelPanel : kBarPanel;
    const ivec2 from = ivec2(gl_FragCoord.xy) - ivec2(margin, size.y - margin - panel.y * scale);
    if (any(lessThan(from, ivec2(0))) || any(greaterThanEqual(from, panel * scale))) return color;
    return wheel ? wheel_legend(from / scale, white) : bar_legend(from / scale, decode, black, white);
}
#endif
