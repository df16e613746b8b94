// Debug view of the image `sunShadow`: shows all shadow maps side by side. A point is brighter if it is nearer to the
// sun. Blue means that the map contains no surface there.
#version 460

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;

uniform sampler2DArray shown;

layout(push_constant) uniform Params { vec2 shownSize; vec2 colorSize; } params;

void main() {
    const int layers = textureSize(shown, 0).z;
    const float side = min(params.colorSize.x / float(layers), params.colorSize.y);
    const vec2 at = uv * params.colorSize / side;
    const int layer = int(at.x);
    color = vec4(0.0, 0.0, 0.0, 1.0);
    if (layer >= layers || at.y >= 1.0) return;
    const float z = textureLod(shown, vec3(fract(at.x), at.y, float(layer)), 0.0).r;
    color.rgb = z > 0.0 ? vec3(z) : vec3(0.1, 0.2, 0.5);
}
