#version 460
// Shows the distance of the faces of the first probes: one row for each probe, with its six faces side by side.
uniform sampler2DArray faceDepth;
uniform sampler2D noted;
out vec4 backbuffer;

void main() {
    const ivec2 at = ivec2(gl_FragCoord.xy), tile = at / 16;
    backbuffer = vec4(0.0, 0.0, texelFetch(noted, ivec2(0), 0).r, 1.0);
    const int layer = 6 * tile.y + tile.x;
    if (tile.x >= 6 || layer >= textureSize(faceDepth, 0).z) return;
    const float depth = texelFetch(faceDepth, ivec3(at % 16, layer), 0).r;
    backbuffer.rgb = vec3(depth > 0.0 ? exp2(-0.002 / depth) : 0.0);
}
