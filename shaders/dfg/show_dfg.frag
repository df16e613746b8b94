// Debug view of the table of directional albedo: scale in red and bias in green. Columns are the square root of the cosine
// of the angle to the viewer, rows are roughnesses.
#version 460
#include "dfg_table.glsl"

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;

readonly buffer Shown { uvec2 items[]; } shown;

layout(push_constant) uniform Params { vec2 colorSize; } params;

void main() {
    const vec2 at = uv * params.colorSize / min(params.colorSize.x, params.colorSize.y);
    color = vec4(0.0, 0.0, 0.0, 1.0);
    if (any(greaterThanEqual(at, vec2(1.0)))) return;
    const uvec2 element = uvec2(at * float(kDfgSide));
    color.rgb = unpacked_dfg(shown.items[element.y * kDfgSide + element.x]);
}
