// Computes the reflection of a directional light that comes from a disc of uniform luminance, such as the sun. The
// highlight is the integral of GGX over the disc.
//
// Half vectors are taken as points (x, y) of the plane at distance 1 along the view direction v: h = (x, y, 1). The
// disc is exactly a circle of this plane, because h is the stereographic projection of the light's direction. With the
// x axis in the direction in which the normal is tilted, the integral of D over the directions of the light is
//     4 α² / π · ∫ dx dy / (y² + B(x)²)²,   B² = |n × h|² + α² (n·h)² at y = 0.
// The integral over y is a closed formula. The integral over x is a sum of 8 to 32 terms, in the variable p with
// tan(angle between h and n at y = 0) = α sinh p. In this variable the integrand is smooth for all α.
#ifndef WEFT_DISC_LIGHT
#define WEFT_DISC_LIGHT
#include "brdf.glsl"
#include "shared/light.glsl"

// Returns ∫ 2 / (1 + η²)² dη from η0 to η1. q = 1 + η0 η1, d = η1 − η0. The second formula avoids the difference of
// nearly equal numbers.
float disc_chord(float q, float d) {
    const float sum = q * q + d * d;
    if (q < 3.0 * d) return atan(d, q) + d * (2.0 - q) / sum;
    const float z = d / q, z2 = z * z;
    return z * z2 * (-1.0 / 3.0 + z2 * (0.2 - z2 * (1.0 / 7.0 - z2 / 9.0))) + d * (d * d + 2.0 * q) / (q * sum);
}

// Returns the factors of F0 (x) and F90 (y) in the integral of D · V · F · n·l over the directions of the disc.
// `to_center`: unit vector to the centre of the disc. `radius`: its angular radius.
vec2 disc_highlight(float alpha, vec3 n, vec3 v, vec3 to_center, float radius) {
    const float nv = clamp(dot(n, v), 1e-3, 1.0);
    const vec3 tilt = n - v * dot(n, v);
    const float tilt_length = length(tilt);
    const vec3 other = abs(v.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0);
    const vec3 ex = tilt_length > 1e-4 ? tilt / tilt_length : normalize(cross(v, other));
    const vec3 ey = cross(v, ex);
    const float sine = sqrt(1.0 - nv * nv);
    // The circle.
    const float scale = 1.0 / max(dot(v, to_center) + cos(radius), 1e-3);
    const vec2 middle = vec2(dot(to_center, ex), dot(to_center, ey)) * scale;
    const float r = sin(radius) * scale;
    // Its ends along x, as p.
    const vec2 ends = middle.x + vec2(-r, r);
    const vec2 tangents = (ends * nv - sine) / max(ends * sine + nv, 1e-3);
    const vec2 p = asinh(tangents / alpha);
    const float half_p = 0.5 * (p.y - p.x), mid_p = 0.5 * (p.x + p.y);
    // If the disc is much larger than the lobe, the lobe is only a part of the range, so more terms are needed.
    const int nodes = int(min(8.0 + 6.0 * half_p, 32.0));
    const float step = kPi / float(nodes);
    vec2 sum = vec2(0.0);
    for (int i = 0; i < nodes; ++i) {
        const float angle = (float(i) + 0.5) * step;
        const float at = mid_p - half_p * cos(angle);
        const float t = alpha * sinh(at), steep = cosh(at);
        const float w = 1.0 / max(nv - t * sine, 1e-3);
        const float x = (t * nv + sine) * w;
        const float reach = (x - middle.x) / r;
        const float chord = r * sqrt(max(0.0, 1.0 - reach * reach));
        const float unit = w * alpha * steep;
        const vec2 eta = (middle.y + vec2(-chord, chord)) / unit;
        const float q = 1.0 + eta.x * eta.y, d = 2.0 * chord / unit;
        const float weight = half_p * sin(angle) / (steep * steep * w);
        const float part = weight * disc_chord(q, d);
        if (part <= 0.0) continue;
        // V, F and n·l at the mean y of the chord.
        const float y = weight * unit * d * (eta.x + eta.y) / ((q * q + d * d) * part);
        const float h2 = x * x + y * y + 1.0;
        const float nl = 2.0 * (x * sine + nv) / h2 - nv;
        if (nl <= 0.0) continue;
        const float reflected = part * smith_visibility(alpha, nl, nv) * nl;
        const float f0_share = schlick(vec3(1.0), 0.0, inversesqrt(h2)).x;
        sum += reflected * vec2(f0_share, 1.0 - f0_share);
    }
    return sum * (2.0 / float(nodes));
}

// Returns the luminance that a surface reflects to the eye from a directional light with a disc.
vec3 disc_reflection(Surface s, vec3 v, Light light) {
    const vec3 to_center = -light.direction;
    const float radius = light.cone_scale;
    if (s.anisotropic) {
        // A wider highlight whose peak is as high as that of the integral.
        s.alphas = sqrt(s.alphas * s.alphas + 0.25 * radius * radius);
        return reflect_light(s, v, to_center) * light.intensity;
    }
    const float center_nl = max(dot(s.normal, to_center), 0.0);
    const vec3 f = schlick(s.f0, s.f90, dot(v, normalize(v + to_center)));
    const vec3 diffuse = s.diffuse * ((1.0 - max(f.r, max(f.g, f.b))) / kPi * center_nl);
    // A disc of luminance L has the illuminance L π sin² radius.
    const float sine = sin(radius);
    const vec2 highlight = disc_highlight(s.alpha, s.normal, v, to_center, radius) / (kPi * sine * sine);
    return (diffuse + s.energy * (s.f0 * highlight.x + s.f90 * highlight.y)) * light.intensity;
}
#endif
