// Debug view of the image `lampShadow`: shows all shadow maps in rows. A point is brighter if it is nearer to the lamp.
// Blue means that the map contains no surface there.
#version 460
#include "shared/lamp_shadow.glsl"

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;

uniform sampler2DArray shown;

layout(push_constant) uniform Params { vec2 shownSize; vec2 colorSize; } params;

void main() {
    const int layers = textureSize(shown, 0).z;
    const float side = sqrt(params.colorSize.x * params.colorSize.y / float(layers));
    const float columns = ceil(params.colorSize.x / side);
    const vec2 at = uv * vec2(columns, columns * params.colorSize.y / params.colorSize.x);
    const int layer = int(at.y) * int(columns) + int(at.x);
    color = vec4(0.0, 0.0, 0.0, 1.0);
    if (layer >= layers) return;
    const float z = textureLod(shown, vec3(fract(at), float(layer)), 0.0).r;
    color.rgb = z > 0.0 ? vec3(1.0 / (1.0 + 0.3 * kLampMapNear_m / z)) : vec3(0.1, 0.2, 0.5);
}
