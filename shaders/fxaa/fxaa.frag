// Fast approximate anti-aliasing: finds edges in a display-encoded picture and blends the pixels at each edge with the
// pixels on its other side. It needs neither history nor depth. Output: display-encoded, like the input.
//
// Source: Lottes 2009, "FXAA" (NVIDIA): the local contrast, the direction and the ends of an edge.
#version 460

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 backbuffer;

uniform sampler2D toned;  // Display-encoded, 0 to 1.

layout(push_constant) uniform Params {
    float fxaaContrast;  // Least contrast of an edge, as a share of the brightest luma around the pixel.
    float fxaaSoftness;  // How much single pixels and thin lines are softened, 0 to 1.
} params;

const float kLeastContrast = 0.03;  // Edges with less contrast are not visible in dark parts of the picture.
const int kMostSteps = 12;
// Lengths of the steps of the search along the edge, in pixels. The first steps are short, because most edges are.
const float kSteps[kMostSteps] = float[kMostSteps](1.0, 1.0, 1.0, 1.0, 1.5, 2.0, 2.0, 2.0, 2.0, 4.0, 8.0, 8.0);

float luma_of(vec3 color) { return dot(color, vec3(0.299, 0.587, 0.114)); }
float luma_at(vec2 at) { return luma_of(textureLod(toned, at, 0.0).rgb); }

// The lumas of a pixel and of the eight pixels around it. The first letter is the row: up, middle, down.
struct Square {
    float ul, um, ur, ml, mm, mr, dl, dm, dr;
};

Square square_at(vec2 at, vec2 px) {
    return Square(luma_at(at + px * vec2(-1, -1)), luma_at(at + px * vec2(0, -1)), luma_at(at + px * vec2(1, -1)),
                  luma_at(at + px * vec2(-1, 0)), luma_at(at), luma_at(at + px * vec2(1, 0)),
                  luma_at(at + px * vec2(-1, 1)), luma_at(at + px * vec2(0, 1)), luma_at(at + px * vec2(1, 1)));
}

// Returns how far the pixel differs from the mean of its neighbours: 0 not at all, 1 by the whole contrast.
float speck(Square s, float contrast) {
    const float mean = (2.0 * (s.um + s.ml + s.mr + s.dm) + s.ul + s.ur + s.dl + s.dr) / 12.0;
    return smoothstep(0.0, 1.0, clamp(abs(mean - s.mm) / contrast, 0.0, 1.0));
}

// Returns true if the edge is nearer to a horizontal than to a vertical line: the second differences along the columns
// are larger than those along the rows.
bool is_horizontal(Square s) {
    const float columns = 2.0 * abs(s.um + s.dm - 2.0 * s.mm) + abs(s.ul + s.dl - 2.0 * s.ml) + abs(s.ur + s.dr - 2.0 * s.mr);
    const float rows = 2.0 * abs(s.ml + s.mr - 2.0 * s.mm) + abs(s.ul + s.ur - 2.0 * s.um) + abs(s.dl + s.dr - 2.0 * s.dm);
    return columns >= rows;
}

// One end of an edge.
struct End {
    float away_px;
    float luma;  // Mean luma of both sides of the edge at the end, minus that at the pixel.
};

// Follows the edge from a point between its two sides until the mean luma of both sides changes by `most`.
End end_of_edge(vec2 at, vec2 along, float middle, float most) {
    End end = End(0.0, 0.0);
    for (int i = 0; i < kMostSteps; ++i) {
        end.away_px += kSteps[i];
        end.luma = luma_at(at + along * end.away_px) - middle;
        if (abs(end.luma) >= most) break;
    }
    return end;
}

// Returns by how many pixels the sample moves across the edge: as much as the edge moves into the pixel, if the edge is
// a line from end to end. An edge that moves out of the pixel gives 0.
float shift_px(End one, End other, bool is_darker) {
    const End near = one.away_px < other.away_px ? one : other;
    const bool moves_in = near.luma < 0.0 != is_darker;
    return moves_in ? 0.5 - near.away_px / (one.away_px + other.away_px) : 0.0;
}

void main() {
    const vec2 px = 1.0 / vec2(textureSize(toned, 0));
    const Square s = square_at(uv, px);
    const float least = min(s.mm, min(min(s.um, s.dm), min(s.ml, s.mr)));
    const float most = max(s.mm, max(max(s.um, s.dm), max(s.ml, s.mr)));
    const float contrast = most - least;
    backbuffer = vec4(textureLod(toned, uv, 0.0).rgb, 1.0);
    if (contrast < max(kLeastContrast, most * params.fxaaContrast)) return;

    const bool horizontal = is_horizontal(s);
    const float before = horizontal ? s.um : s.ml, after = horizontal ? s.dm : s.mr;
    const bool is_before = abs(before - s.mm) >= abs(after - s.mm);
    const float other = is_before ? before : after;  // Luma of the pixel on the other side of the edge.
    const vec2 across = (horizontal ? vec2(0.0, px.y) : vec2(px.x, 0.0)) * (is_before ? -1.0 : 1.0);
    const vec2 along = horizontal ? vec2(px.x, 0.0) : vec2(0.0, px.y);
    const vec2 between = uv + 0.5 * across;
    const float middle = 0.5 * (s.mm + other), limit = 0.25 * abs(other - s.mm);
    const End one = end_of_edge(between, -along, middle, limit), two = end_of_edge(between, along, middle, limit);
    const float edge = shift_px(one, two, s.mm < middle);
    const float blur = speck(s, contrast);
    const float moved = max(edge, params.fxaaSoftness * blur * blur);
    backbuffer.rgb = textureLod(toned, uv + across * moved, 0.0).rgb;
}
