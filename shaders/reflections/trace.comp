// Traces one or more rays of each texel through the depth image, in the directions that its surface mirrors to the eye.
// The light of a hit is that of the same place in the lit picture of the previous frame.
// Output ssrRay: the rays; see ray.glsl. Output ssrLight: rgb: radiance of the hit × preExposure × confidence; a:
// confidence that the picture shows what the ray meets, 0 to 1. Without a hit: rgb: radiance of the surroundings in the
// direction of the ray × preExposure; a: 0.
#version 460
#include "brdf.glsl"
#include "environment_light.glsl"
#include "frame_set.glsl"
#include "half_float.glsl"
#include "march.glsl"
#include "ray.glsl"
#include "sample_ggx.glsl"
#include "tiles.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(std430) readonly buffer Tiles { uint items[]; } tiles;  // Those with a texel that reflects.
uniform sampler2D normal;
uniform sampler2D velocity;
uniform sampler2D ssrSurface;
uniform sampler2D ssrScene;
layout(rg32ui) writeonly uniform uimage2DArray ssrRay;
layout(rgba16f) writeonly uniform image2DArray ssrLight;

layout(push_constant) uniform Params {
    float ssrSceneValid;  // 1 if a frame has written ssrScene, otherwise 0.
    float ssrThickness;
    uint ssrScale;
    uint ssrSteps;
    uint ssrNoise;
    uint ssrPyramid;
} params;

// If the depth in the previous frame differs by more than this share, that frame shows another surface, and the hit has
// no light.
const float kSameDepth = 0.05;
// A ray stands for a part of the lobe: for the solid angle 1 / (kShares · density). More than kShares rays are averaged
// over neighbours and frames, so the parts overlap. Source: Křivánek and Colbert 2008, "Real-time Shading with Filtered
// Importance Sampling".
const float kShares = 16.0;
// The part of the picture that a ray reads is narrower by this factor, because a blurred picture mixes near and far
// objects.
const float kHitShare = 0.18;
// Where the eye sees a surface at a small angle, as at the outline of a ball, the depth changes much from pixel to pixel,
// and neighbouring rays alternately meet the object and miss it. So the confidence falls to 0, from this cosine of the
// angle between normal and eye on.
const float kSeenWell = 0.12;
// Steps of evenly distributed (low-discrepancy) sequences.
const float kGolden = 0.61803399, kPlastic = 0.75487767, kPlastic2 = 0.56984029;

// Returns two numbers from 0 to 1: a Hammersley set over 4 × 4 texels, moved in each frame and for each ray.
vec2 random_of(ivec2 texel, uint ray) {
    if (params.ssrNoise == 0u) return vec2(0.5);
    const uvec2 at = uvec2(texel) & 3u;
    const uint i = (at.x & 1u) | (at.y & 1u) << 1 | (at.x & 2u) << 1 | (at.y & 2u) << 2;
    const uint turned = bitfieldReverse(i) >> 28;
    const vec2 place = (vec2(i, turned) + 0.5) / 16.0;
    return fract(place + vec2(kPlastic, kPlastic2) * float(frame.frame_index % 4096u) + kGolden * float(ray));
}

// Returns the change of a depth from one texel to the next: the smaller one of both sides, because the other side may
// be a different surface.
float least_change(float before, float here, float after) {
    if (before <= 0.0) return after > 0.0 ? after - here : 0.0;
    if (after <= 0.0) return here - before;
    return abs(after - here) < abs(here - before) ? after - here : here - before;
}

float depth_at(ivec2 texel) {
    const ivec2 size = textureSize(ssrSurface, 0);
    if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, size))) return 0.0;
    return texelFetch(ssrSurface, texel, 0).z;
}

Plane plane_of(ivec2 texel, float z) {
    const float side = float(params.ssrScale);
    const vec2 slope = vec2(least_change(depth_at(texel - ivec2(1, 0)), z, depth_at(texel + ivec2(1, 0))),
                            least_change(depth_at(texel - ivec2(0, 1)), z, depth_at(texel + ivec2(0, 1))));
    return Plane(vec2(texel * int(params.ssrScale)) + 0.5, slope / side, z);
}

// Returns radiance × preExposure × confidence of a hit, and the confidence. `width_px`: of the ray at the hit.
vec4 light_of(Hit hit, Line line, vec3 place, float width_px) {
    const vec2 size = vec2(textureSize(depth, 0));
    // The previous picture was moved by another jitter. The mean over all jitters is 0.
    const vec2 uv = (line.start.xy + line.step.xy * hit.s) / size - view.jitter_uv;
    const vec2 from = uv - texelFetch(velocity, hit.pixel, 0).xy;
    const float inside = inside_picture(from);
    if (params.ssrSceneValid <= 0.0 || inside <= 0.0) return vec4(0.0);
    const float before_m = texelFetch(ssrScene, ivec2(from * size), 0).a;
    const float expected_m = (view.prev_view_projection * vec4(place, 1.0)).w;
    if (abs(before_m - expected_m) > kSameDepth * expected_m) return vec4(0.0);
    const float lod = log2(max(width_px, 1.0));
    const vec3 color = textureLod(ssrScene, from, lod).rgb * (frame.pre_exposure / frame.prev_pre_exposure);
    return vec4(min(color, vec3(65000.0)), 1.0) * (inside * (1.0 - hit.behind));
}

// Returns the radiance of the surroundings in cd/m² over a solid angle. A filtered cube for the roughness √α averages
// over the solid angle 4π α².
vec3 sky_of(vec3 direction, float solid_angle) {
    const float roughness = min(sqrt(sqrt(solid_angle / (4.0 * kPi))), 1.0);
    if (!HAS_environmentCube) return blurred_radiance(direction, direction, roughness);
    return filtered_radiance(direction, roughness);
}

struct Reflector {
    vec3 position, normal, to_eye;
    float alpha;
    Plane plane;
};

// Returns a ray without its length. The density of a ray into the surface is 0.
Ray ray_from(ivec2 texel, uint index, Reflector r) {
    if (r.alpha < kMirrorAlpha) {
        const vec3 mirrored = reflect(-r.to_eye, r.normal);
        return Ray(mirrored, 0.0, dot(mirrored, r.normal) > 0.0 ? 1.0 : 0.0);
    }
    const mat3 basis = basis_around(r.normal);
    const vec3 v = r.to_eye * basis, direction = basis * sample_mirrored(v, r.alpha, random_of(texel, index));
    const vec3 h = normalize(r.to_eye + direction);
    const float density = mirrored_density(v, r.alpha, ggx_distribution(r.alpha, r.normal, h));
    return Ray(direction, 0.0, dot(direction, r.normal) > 0.0 ? density : 0.0);
}

void trace(ivec2 texel, uint index, Reflector r) {
    Ray ray = ray_from(texel, index, r);
    vec4 light = vec4(0.0);
    if (ray.pdf > 0.0) {
        const Line line = line_of(r.position, ray.direction, vec2(textureSize(depth, 0)));
        // Where a shading normal differs from the surface, the ray can start into the surface.
        const bool leaves = line.step.z > dot(r.plane.slope, line.step.xy);
        const int most_level = params.ssrPyramid != 0u ? kLastLevel : 0;
        Hit hit = Hit(false, ivec2(0), 0.0, 0.0, 0.0);
        if (leaves) hit = march(line, r.plane, params.ssrThickness, most_level, params.ssrSteps);
        ray.length_m = -length_at(line, hit.free);
        const float solid_angle = r.alpha < kMirrorAlpha ? 0.0 : 1.0 / (kShares * ray.pdf);
        // A surface whose back the ray meets is no hit.
        const vec3 met = octahedral_decode(texelFetch(normal, hit.pixel, 0).xy);
        if (hit.found && dot(met, ray.direction) < 0.0) {
            ray.length_m = length_at(line, hit.s);
            const float depth_m = line.w + line.w_step * ray.length_m;
            const float px_per_m = 0.5 * view.projection[0][0] * view.viewport_px.x / depth_m;
            const float width_px = kHitShare * sqrt(solid_angle) * ray.length_m * px_per_m;
            const vec3 place = r.position + ray.direction * ray.length_m;
            const float seen = smoothstep(0.0, kSeenWell, dot(met, normalize(view.eye - place)));
            light = light_of(hit, line, place, width_px) * seen;
        } else {
            light.rgb = min(sky_of(ray.direction, solid_angle) * frame.pre_exposure, vec3(65000.0));
        }
    }
    imageStore(ssrRay, ivec3(texel, index), uvec4(packed_ray(ray), 0u, 0u));
    imageStore(ssrLight, ivec3(texel, index), light);
}

void main() {
    const uint at = place_in_list();
    if (at >= tiles.items[3]) return;
    const ivec2 size = imageSize(ssrRay).xy;
    const ivec2 texel = texel_of_tile(tiles.items[kTilesBegin + at], size);
    if (any(greaterThanEqual(texel, size))) return;
    const vec4 surface = texelFetch(ssrSurface, texel, 0);
    const uint rays = uint(imageSize(ssrRay).z);
    if (surface.z <= 0.0 || surface.w >= kNoRays) {
        for (uint i = 0u; i < rays; ++i) {
            imageStore(ssrRay, ivec3(texel, i), uvec4(packed_ray(kRayOfNone), 0u, 0u));
            imageStore(ssrLight, ivec3(texel, i), vec4(0.0));
        }
        return;
    }
    const vec2 place = (vec2(texel * int(params.ssrScale)) + 0.5) / vec2(textureSize(depth, 0));
    const vec3 position = world_position(place, surface.z);
    const Reflector r = Reflector(position, octahedral_decode(surface.xy), normalize(view.eye - position),
                                  alpha_of(surface.w), plane_of(texel, surface.z));
    for (uint i = 0u; i < rays; ++i) trace(texel, i, r);
}
