// The light that a surface mirrors, as far as the picture itself shows it. Optional port of
// graphs/modules/reflections.json: `ssr`.
#ifndef WEFT_SCREEN_REFLECTIONS
#define WEFT_SCREEN_REFLECTIONS
#include "frame_set.glsl"
#include "octahedral.glsl"

layout(constant_id = 35) const bool HAS_ssr = false;
// Layer 0: radiance × preExposure × confidence (rgb) and confidence (a). Layer 1: normal (xy, octahedral), distance to
// the eye in metres (z; 0: the sky), and number of blended frames plus the deviation of their light (w; below 0: no rays). Layer 2, of the rays that hit
// nothing in the picture: 1 / the distance for which nothing is in their way, in 1/m (x; 0: no such ray), and radiance
// of the surroundings × preExposure (yzw).
uniform sampler2DArray ssr;

// The confidence falls to 0 over this share of the picture at its edges.
const float kEdge = 0.05;
// The picture shows a place if the distances to the eye differ by less than this share.
const float kSamePlace = 0.1;
// Below this α, a surface reflects like a mirror: all rays of a texel have the same direction.
const float kMirrorAlpha = 0.003;

// light: radiance × confidence in cd/m² (rgb), and the confidence (a): the share of the mirrored light that the picture
// shows. The other members describe the rest of the mirrored light, 1 − confidence. free_m: for this distance, nothing is in the way of the light; 0:
// unknown. open: radiance of the surroundings in cd/m², as if nothing were in the way.
struct ScreenReflection {
    vec4 light;
    vec3 open;
    float free_m;
};

// Returns 1 inside of the picture; falls to 0 towards its edges.
float inside_picture(vec2 uv) {
    const vec2 inside = smoothstep(0.0, kEdge, uv) * smoothstep(0.0, kEdge, 1.0 - uv);
    return inside.x * inside.y;
}

// Returns the number of pixels of a texel along each axis.
int pixels_of_texel() {
    const int texels = textureSize(ssr, 0).x;
    return (int(view.viewport_px.x) + texels - 1) / texels;
}

// Returns how surely the picture shows a place, 0 to 1. Rays find such a place, except behind transparent surfaces: there,
// the result is 0.
float shown_in_picture(vec3 place) {
    const vec4 clip = view.view_projection * vec4(place, 1.0);
    if (clip.w <= 0.0) return 0.0;
    const vec2 uv = clip.xy / clip.w * 0.5 + 0.5;
    const float inside = inside_picture(uv);
    if (inside <= 0.0) return 0.0;
    const float distance_m = texelFetch(ssr, ivec3(ivec2(uv * view.viewport_px) / pixels_of_texel(), 1), 0).z;
    return abs(distance_m - distance(place, view.eye)) < kSamePlace * distance_m ? inside : 0.0;
}

// Returns the mirrored light at a pixel. It is the mean of the four texels around a pixel. A texel counts less if its
// point is not in the plane of the surface, or its normal differs. A pixel whose surface no texel shows gets the
// confidence 0.
ScreenReflection screen_reflection(ivec2 pixel, vec3 position, vec3 n) {
    const ivec2 last = textureSize(ssr, 0).xy - 1;
    const int side = pixels_of_texel();
    const ivec2 low = pixel / side;
    const vec2 share = vec2(pixel - low * side) / float(side);
    const float pixel_m = length(position - view.eye) * 2.0 / (view.projection[0][0] * view.viewport_px.x);
    vec4 light = vec4(0.0), open = vec4(0.0);
    float weights = 1e-4, opens = 0.0;
    for (int i = 0; i < (side > 1 ? 4 : 1); ++i) {
        const ivec2 at = min(low + ivec2(i & 1, i >> 1), last);
        const vec4 shape = texelFetch(ssr, ivec3(at, 1), 0);
        if (shape.z <= 0.0 || shape.w < 0.0) continue;
        const vec2 uv = (vec2(at * side) + 0.5) * view.inverse_viewport;
        const float off = dot(view.eye + ray_direction(uv) * shape.z - position, n) / pixel_m;
        const float alike = max(dot(octahedral_decode(shape.xy), n), 0.0), near = 1.0 / (1.0 + off * off);
        const vec2 close = mix(1.0 - share, share, vec2(i & 1, i >> 1));
        const float weight = max(close.x * close.y, 1e-3) * near * near * pow(alike, 32.0);
        light += weight * texelFetch(ssr, ivec3(at, 0), 0);
        weights += weight;
        const vec4 other = texelFetch(ssr, ivec3(at, 2), 0);
        if (other.x <= 0.0) continue;
        open += weight * other;
        opens += weight;
    }
    const vec3 exposed = vec3(frame.pre_exposure);
    const vec4 mean = light / (weights * vec4(exposed, 1.0));
    return opens > 1e-4 ? ScreenReflection(mean, open.yzw / (opens * exposed), opens / open.x)
                        : ScreenReflection(mean, vec3(0.0), 0.0);
}
#endif
