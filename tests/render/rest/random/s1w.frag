#version 460
layout(push_constant) uniform Params { float value; } params;
uniform sampler2D a;
uniform sampler2DArray w;
layout(location = 0) out vec4 dst;

void main() {
    const ivec2 at = ivec2(gl_FragCoord.xy);
    dst = vec4(params.value + 0.125 + 0.5 * texelFetch(a, at, 0).x + 0.25 * (texelFetch(w, ivec3(at, 0), 0).x + texelFetch(w, ivec3(at, 1), 0).x), vec2(at) / 64.0, 1);
}
