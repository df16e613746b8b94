// Replaces the picture behind a refractive surface by what the surface shows of it: bent by the normal of the surface
// (Snell's law), tinted by its base colour, and absorbed by the body behind it (law of Beer and Lambert). The pass draws
// only the nearest surface of each pixel. The mirrored light is added later, when the surface itself is drawn.
//
// The body ends at the opaque surface behind it, or after material.thickness_m along the normal. So at the edge of
// water, where the depth is 0, nothing is bent or absorbed, and there is no seam.
#version 460
#include "frame_set.glsl"
#include "half_float.glsl"
#include "material_set.glsl"
#include "ripples.glsl"
#include "surface_fragment.glsl"

uniform sampler2D depth;   // Of the opaque surfaces.
uniform sampler2D refractionSource;  // The picture without transparent surfaces.

layout(location = 5) in vec3 world_point;

layout(location = 0) out vec4 hdr;

const float kSteepest = 0.2;  // Limits the way of a ray through the body at grazing angles; cosine to the normal.
const float kSky_m = 1e6;     // Distance of the sky.
const int kSearchSteps = 8;

ivec2 pixel_at(vec2 uv) {
    const ivec2 size = textureSize(depth, 0);
    return clamp(ivec2(uv * vec2(size)), ivec2(0), size - 1);
}

// Returns the opaque surface behind the position `uv` of the picture.
vec3 surface_at(vec2 uv) {
    const float z = texelFetch(depth, pixel_at(uv), 0).r;
    return z > 0.0 ? world_position(uv, z) : view.eye + kSky_m * ray_direction(uv);
}

// Returns the position in the picture of a point in front of the camera.
vec2 place_in_picture(vec3 point) {
    const vec4 clip = view.view_projection * vec4(point, 1.0);
    return clip.xy / clip.w * 0.5 + 0.5;
}

// Returns a factor for `offset`, at most 1, with which it does not leave the picture. The factor is below 1 where the room
// to the edge is less than twice the offset, and it changes smoothly, so that the edge is not repeated.
float share_inside(vec2 uv, vec2 offset) {
    const vec2 room = mix(uv, 1.0 - uv, greaterThan(offset, vec2(0.0)));
    const vec2 shares = min(room / max(abs(offset), vec2(1e-6)), vec2(2.0));
    const float share = min(shares.x, shares.y);
    return share - 0.25 * share * share;
}

bool is_hidden(vec2 uv, vec3 face) { return dot(world_point - surface_at(uv), face) < 0.0; }

// Returns `bent`. If a surface in front of the refractive one hides it, returns a place on the way from `uv` to it that is
// not hidden. With the third power of the share of the way, the picture continues at the outline of the hidden part, and
// is not stretched into streaks behind it.
vec2 seen_before(vec2 uv, vec2 bent, vec3 face) {
    if (!is_hidden(bent, face)) return bent;
    float seen = 0.0, hidden = 1.0;
    for (int i = 0; i < kSearchSteps; ++i) {
        const float middle = 0.5 * (seen + hidden);
        if (is_hidden(mix(uv, bent, middle), face)) hidden = middle;
        else seen = middle;
    }
    return mix(uv, bent, seen * seen * seen);
}

void main() {
    const vec3 n = rippled_normal();
    const vec4 base = base_color();
    const vec2 uv = gl_FragCoord.xy / view.viewport_px;
    if (gl_FragCoord.z <= texelFetch(depth, ivec2(gl_FragCoord.xy), 0).r) discard;

    const vec3 face = mesh_normal();
    const vec3 ray = refract(normalize(world_point - view.eye), n, 1.0 / max(material.ior, 1.0));
    const float slope = max(-dot(ray, face), kSteepest);
    const float here_m = clamp(dot(world_point - surface_at(uv), face), 0.0, material.thickness_m);
    vec2 bent = place_in_picture(world_point + ray * (here_m / slope));
    bent = uv + (bent - uv) * share_inside(uv, bent - uv);
    bent = seen_before(uv, bent, face);
    const float there_m = clamp(dot(world_point - surface_at(bent), face), 0.0, material.thickness_m);

    // Light is not interpolated with that of surfaces in front of the refractive one.
    const bool hidden = any(greaterThan(textureGather(depth, bent), vec4(gl_FragCoord.z)));
    const vec3 light = hidden ? texelFetch(refractionSource, pixel_at(bent), 0).rgb : textureLod(refractionSource, bent, 0.0).rgb;
    const vec3 passed = base.rgb * exp(-material.absorption_per_m * (there_m / slope));
    const vec3 straight = texelFetch(refractionSource, ivec2(gl_FragCoord.xy), 0).rgb;
    // When the surface is drawn, it lets 1 − alpha + alpha · transmission of this light pass. The first part is straight.
    const float bent_part = base.a * material.transmission * (1.0 - occlusion_roughness_metalness().b);
    const vec3 through = mix(straight, light * passed, bent_part / max(1.0 - base.a + bent_part, 1e-6));
    hdr = vec4(nearest_half(through), 1.0);
}
