// Renders land, water and sky at sunset, with four rays per pixel. Output rgb: scene-linear radiance. Output alpha: how
// much of the pixel is sky; light shafts come only from visible sky.
#version 460
#include "half_float.glsl"
#include "land.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D land;
layout(rgba16f) writeonly uniform image2D scene;

layout(push_constant) uniform Params { float time; float mist; } params;

const float kFarthest = 16.0;
const int kRays = 4, kSteps = 320, kHalvings = 5;
const vec3 kSunLight = vec3(7.5, 3.7, 1.5), kShade = vec3(0.16, 0.20, 0.34);

float height_at(vec2 xz) { return textureLod(land, land_uv(xz), 0.0).r; }

vec3 sky(vec3 ray) {
    const float up = max(ray.y, 0.0), toward = max(dot(ray, to_sun()), 0.0);
    vec3 color = mix(vec3(0.95, 0.50, 0.30), vec3(0.36, 0.30, 0.46), smoothstep(0.0, 0.22, up));
    color = mix(color, vec3(0.055, 0.10, 0.26), smoothstep(0.12, 0.62, up));
    color += vec3(1.0, 0.42, 0.12) * (0.4 * pow(toward, 8.0) + 0.9 * pow(toward, 60.0));
    color += vec3(1.6, 1.1, 0.65) * pow(toward, 400.0);
    const vec2 above = ray.xz / (ray.y + 0.08) * vec2(0.9, 1.5) + vec2(0.02, 0.0) * params.time;
    const vec2 swept = above + 0.8 * soft_noise(above * 0.6, 3);
    const float cloud = smoothstep(0.46, 0.78, soft_noise(swept * vec2(0.8, 1.7) + 5.0, 6)) * smoothstep(0.015, 0.16, up);
    const vec3 lit = mix(vec3(0.34, 0.20, 0.27), vec3(1.9, 0.78, 0.36), pow(toward, 3.0)) + vec3(0.30, 0.10, 0.06) * (1.0 - up);
    color = mix(color, lit, cloud * 0.8);
    return color + vec3(42.0, 26.0, 13.0) * smoothstep(0.99982, 0.99992, toward) * (1.0 - cloud);
}

// Returns the distance at which the ray hits the land, or kFarthest. The length of a step is a quarter of the
// height above the land, and at least `least` times the distance. When a step ends below the land, the
// interval of this step is halved 5 times. Without the halvings, the ray could end on the far side of a
// ridge. That side is sunlit, so the pixel would be too bright.
float land_distance(vec3 from, vec3 ray, float start, float least) {
    float t = start, before = start, gap = 1.0;
    for (int i = 0; i < kSteps; ++i) {
        const vec3 p = from + ray * t;
        if (t >= kFarthest || (p.y > kHighest && ray.y > 0.0)) return kFarthest;
        gap = p.y - height_at(p.xz);
        if (gap <= 0.0) break;
        before = t;
        t += max(0.25 * gap, least * t);
    }
    if (gap > 0.0) return kFarthest;
    for (int i = 0; i < kHalvings; ++i) {
        const float middle = 0.5 * (before + t);
        const vec3 p = from + ray * middle;
        if (p.y > height_at(p.xz))
            before = middle;
        else
            t = middle;
    }
    return t;
}

float sunlit(vec3 p) {
    const vec3 l = to_sun();
    float lit = 1.0, t = 0.03;
    for (int i = 0; i < 28; ++i, t *= 1.22) {
        const vec3 q = p + l * t;
        lit = min(lit, 0.5 + 14.0 * (q.y - height_at(q.xz)) / t);
    }
    return smoothstep(0.0, 1.0, lit);
}

// Returns the width of a pixel at this distance, in km.
float footprint_km(float distance_km) { return distance_km * 2.0 / (kFocal * float(imageSize(scene).y)); }

vec3 normal_at(vec2 xz, float distance_km) {
    const float width = footprint_km(distance_km), e = max(0.008, 0.7 * width);
    const vec2 rough = vec2(soft_noise_within(xz * 60.0, 4, 60.0 * width),
                            soft_noise_within(xz * 60.0 + 9.0, 4, 60.0 * width)) - 0.47;
    const vec2 slope = vec2(height_at(xz + vec2(e, 0.0)) - height_at(xz - vec2(e, 0.0)),
                            height_at(xz + vec2(0.0, e)) - height_at(xz - vec2(0.0, e))) / (2.0 * e);
    return normalize(vec3(-slope.x - rough.x * 0.7, 1.0, -slope.y - rough.y * 0.7));
}

vec3 ground(vec3 p, float distance_km) {
    const vec3 n = normal_at(p.xz, distance_km);
    const float width = footprint_km(distance_km), tree_rate = 140.0 / (1.0 + 0.4 * distance_km);
    const float patchy = soft_noise_within(p.xz * 9.0, 4, 9.0 * width);
    const float trees = soft_noise_within(p.xz * tree_rate, 3, tree_rate * width);
    const float snow = smoothstep(0.55, 0.95, p.y + 0.7 * (patchy - 0.45)) * smoothstep(0.42, 0.72, n.y);
    const float woods = smoothstep(0.62, 0.3, p.y + 0.5 * (patchy - 0.45)) * smoothstep(0.35, 0.65, n.y);
    vec3 albedo = mix(vec3(0.17, 0.14, 0.13), vec3(0.26, 0.21, 0.18), patchy);
    albedo = mix(albedo, vec3(0.045, 0.065, 0.03) * (0.3 + 1.5 * trees), woods);
    albedo = mix(albedo, vec3(0.82, 0.84, 0.90), snow);
    const float direct = max(dot(n, to_sun()), 0.0) * sunlit(p + n * 0.004);
    return albedo * (kSunLight * direct + kShade * (0.6 + 0.4 * n.y) + vec3(0.20, 0.11, 0.07) * max(0.0, 0.4 - 0.6 * n.z));
}

// Mixes the colour with fog along the ray. The fog is dense close to the water and thin higher up. It is bright
// around the sun.
vec3 through_air(vec3 color, vec3 from, vec3 ray, float distance_km) {
    const float fall = 4.5, k = fall * ray.y;
    const float column = exp(-fall * from.y) * (abs(k) > 1e-3 ? (1.0 - exp(-k * distance_km)) / k : distance_km);
    const float veil = 1.0 - exp(-0.085 * distance_km - params.mist * column);
    const float toward = max(dot(ray, to_sun()), 0.0);
    const vec3 air = mix(vec3(0.25, 0.25, 0.40), vec3(0.92, 0.52, 0.34), 0.25 + 0.75 * pow(toward, 4.0)) +
                     vec3(1.2, 0.55, 0.2) * pow(toward, 24.0);
    return mix(color, air, veil);
}

vec3 land_or_sky(vec3 from, vec3 ray, float start, float least, out float met) {
    met = land_distance(from, ray, start, least);
    const vec3 p = from + ray * met;
    return met < kFarthest ? through_air(ground(p, met), from, ray, met) : sky(ray);
}

// Returns the normal of the water surface with waves. With growing distance, the waves become flatter.
vec3 wave_normal(vec2 xz, float distance_km) {
    const vec2 p = xz * vec2(90.0, 160.0) + vec2(0.3, 0.8) * params.time;
    const float calm = 0.035 / (1.0 + 1.6 * distance_km);
    return normalize(vec3((soft_noise(p, 3) - 0.44) * calm, 1.0, (soft_noise(p + 40.0, 3) - 0.44) * calm * 2.0));
}

// Returns the colour at a point of the picture. Alpha is 1 if the ray sees the sky, otherwise 0.
vec4 seen_at(vec2 at, vec2 size) {
    const vec2 screen = (2.0 * at - size) / size.y;
    const vec3 ray = normalize(vec3(screen.x, 0.10 - screen.y, kFocal));
    float met;
    const vec3 color = land_or_sky(kEye, ray, 0.05, 0.004, met);
    const float water = ray.y < 0.0 ? -kEye.y / ray.y : kFarthest;
    if (water >= met || water >= kFarthest) return vec4(color, met < kFarthest ? 0.0 : 1.0);
    const vec3 p = kEye + ray * water;
    const vec3 n = wave_normal(p.xz, water);
    vec3 up = reflect(ray, n);
    up.y = max(up.y, 0.004);
    float ignored;
    const vec3 mirrored = land_or_sky(p, normalize(up), 0.03, 0.015, ignored);
    const float fresnel = 0.02 + 0.98 * pow(1.0 - max(dot(-ray, n), 0.0), 5.0);
    return vec4(through_air(mix(vec3(0.008, 0.025, 0.04), min(mirrored, vec3(9.0)), fresnel), kEye, ray, water), 0.0);
}

// Averages the rays of a pixel. Brighter rays get less weight: otherwise, a sunlit ridge that is thinner than a pixel
// would appear as single dots.
void main() {
    const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy), size = imageSize(scene);
    if (any(greaterThanEqual(pixel, size))) return;
    vec3 sum = vec3(0.0);
    float weights = 0.0, open = 0.0;
    for (int i = 0; i < kRays; ++i) {
        const vec2 within = (vec2(i, (2 * i + 1) % 5) + 0.5) / float(kRays);  // Rows 1, 3, 0, 2: a rotated grid.
        const vec4 seen = seen_at(vec2(pixel) + within, vec2(size));
        const float weight = 1.0 / (1.0 + max(seen.r, max(seen.g, seen.b)));
        sum += min(seen.rgb, vec3(60.0)) * weight;
        weights += weight;
        open += seen.a / float(kRays);
    }
    imageStore(scene, pixel, vec4(nearest_half(sum / weights), open));
}
