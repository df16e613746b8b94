// Debug view of the buffer `adaptation`: the histogram of the picture over EV. The bright parts of the bars stand for
// the pixels that the light meter uses. The white line is the metered EV and the orange line the EV to which the eye
// has adapted; the number at the upper left is the exposure of the picture. Below the bars is the scale in EV.
#version 460
#include "adaptation.glsl"
#include "debug_digits.glsl"

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;

readonly buffer Shown { AdaptationState state; } shown;

layout(push_constant) uniform Params {
    vec2 colorSize;
    float meterFrom, meterTo;
} params;

const vec3 kGround = vec3(0.08, 0.09, 0.12), kBar = vec3(0.33, 0.38, 0.5), kMetered = vec3(0.55, 0.8, 1.0);
const vec3 kOrange = vec3(1.0, 0.6, 0.2);
const float kStops = float(kBins) / kBinsPerStop;
const int kScaleStep_ev = 4;

float largest_share() {
    float largest = 1e-6;
    for (uint i = 0u; i < kBins; ++i) largest = max(largest, shown.state.shares[i]);
    return largest;
}

// Returns the colour of a bar at a height from 0 to 1. The metered part of the bar is its lower part.
vec3 bar_color(uint bin, float height) {
    float below = 0.0;
    for (uint i = 0u; i < bin; ++i) below += shown.state.shares[i];
    const float share = shown.state.shares[bin], largest = largest_share();
    if (height >= share / largest) return kGround;
    return height < metered_part(below, share, params.meterFrom, params.meterTo) / largest ? kMetered : kBar;
}

// Returns true if the pixel is part of the scale: a number every few EV, centred below its place.
bool is_scale(ivec2 at, int width) {
    for (int ev = int(kLeastEv); ev <= int(kLeastEv + kStops); ++ev) {
        if (ev % kScaleStep_ev != 0) continue;
        const int center = int((float(ev) - kLeastEv) / kStops * float(width)), wide = decimal_width(float(ev));
        if (is_decimal(float(ev), at - ivec2(center - wide / 2, 0))) return true;
    }
    return false;
}

void main() {
    const ivec2 size = ivec2(params.colorSize), pixel = ivec2(gl_FragCoord.xy);
    const int scale = max(1, size.y / 270), floor_px = size.y - 9 * scale;
    const float ev = kLeastEv + uv.x * kStops, line = 0.75 * float(scale) * kStops / params.colorSize.x;
    if (is_decimal(shown.state.exposure_ev, pixel / scale - 3)) color = vec4(1.0);
    else if (pixel.y >= floor_px)
        color = vec4(vec3(is_scale((pixel - ivec2(0, floor_px + 2 * scale)) / scale, size.x / scale)), 1.0);
    else if (abs(ev - shown.state.adapted_ev) < line) color = vec4(kOrange, 1.0);
    else if (abs(ev - shown.state.metered_ev) < line) color = vec4(1.0);
    else color = vec4(bar_color(uint(uv.x * float(kBins)), 1.05 * (1.0 - float(pixel.y) / float(floor_px))), 1.0);
}
