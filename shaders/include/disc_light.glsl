// Reflection of the light of a distant disc of uniform luminance, such as the sun.
//
// The half vectors of all directions to the disc fill an ellipse in the plane of slopes, in which a half vector h has
// the position h.xy / h.z (in the frame of the surface, in units of α). The GGX distribution of slopes is
// 1 / (π (1 + |m|²)²). The same formula gives the form factor of a plane at the distance 1 from a point that faces it:
// the share of each m. So the integral of the distribution over the ellipse is the form factor of an elliptical disc (as
// in Heitz and Hill 2017, "Real-Time Line- and Disk-Light Shading with Linearly Transformed Cosines"). For an ellipse
// with the centre m and the matrix C (the ellipse is m + √C · unit disc) it is
//     √det C · μ · c² / √det(1 + μC)   with   1 / μ = 1 + m·w,   1 / c² = 1 + w·w,   w = (1 + μC)⁻¹ m.
// w is the mean slope of the facets that mirror the disc. Fresnel term and masking-shadowing are those of this slope.
#ifndef WEFT_DISC_LIGHT
#define WEFT_DISC_LIGHT
#include "brdf.glsl"

// An ellipse in the plane of slopes.
struct SlopeEllipse {
    vec2 center;
    vec2 a, b;  // Vectors from the centre to the ends of two diameters that are conjugate.
};

// Returns the slopes of the half vectors of a disc. The half vectors of its edge, v + l, lie on a circle in space, whose
// projection from the origin to the plane of slopes is exactly an ellipse. `eye` and `light` are in the frame of the
// surface.
SlopeEllipse slopes_of_disc(vec3 eye, vec3 light, float radius) {
    const float sine = sin(radius), cosine = cos(radius);
    const float across = length(light.xy);
    const vec2 outward = across > 1e-5 ? light.xy / across : vec2(1.0, 0.0);
    const float height = eye.z + light.z * cosine;
    const vec2 middle = (eye.xy + light.xy * cosine) / height;
    const float tilt = sine * across / height, rest = max(1.0 - tilt * tilt, 1e-4);
    SlopeEllipse e;
    e.a = -sine / (height * rest) * (light.z * outward + middle * across);
    e.b = sine / (height * sqrt(rest)) * vec2(-outward.y, outward.x);
    e.center = middle - tilt * e.a;
    return e;
}

// Returns the mean slope w (xy) and the form factor (z) of an ellipse of slopes, by the formulas at the top of this
// file. The number μ in these formulas is between 1 / (1 + m·m) and 1, where m is the centre of the ellipse. Seven
// bisections of the logarithm of μ and two steps of Newton's method find μ.
vec3 form_factor(SlopeEllipse e) {
    const vec2 m = e.center;
    const float cx = e.a.x * e.a.x + e.b.x * e.b.x, cy = e.a.y * e.a.y + e.b.y * e.b.y;
    const float cxy = e.a.x * e.a.y + e.b.x * e.b.y;
    const float area = abs(e.a.x * e.b.y - e.a.y * e.b.x), det = area * area, trace = cx + cy;
    const vec2 turned = vec2(cy * m.x - cxy * m.y, cx * m.y - cxy * m.x);
    const float m2 = dot(m, m), m_turned = dot(m, turned);
    float low = 1.0 / (1.0 + m2), high = 1.0;
    for (int i = 0; i < 7; ++i) {
        const float middle = sqrt(low * high);
        const float value = middle * (1.0 + (m2 + middle * m_turned) / (1.0 + middle * (trace + middle * det)));
        if (value < 1.0) low = middle; else high = middle;
    }
    float mu = low;
    for (int i = 0; i < 2; ++i) {
        const vec2 near = (m + mu * turned) / (1.0 + mu * (trace + mu * det));
        mu -= (mu * (1.0 + dot(m, near)) - 1.0) / (1.0 + dot(near, near));
    }
    const float whole = 1.0 + mu * (trace + mu * det);
    const vec2 w = (m + mu * turned) / whole;
    return vec3(w, area * mu / (sqrt(whole) * (1.0 + dot(w, w))));
}

// Returns the specular BRDF times n·l, averaged over the disc around `l`. `radius` is the angular radius in radians.
// nl and nv are the cosines of the angles of l and v to the normal.
vec3 disc_specular(Surface s, vec3 v, vec3 l, float radius, float nl, float nv) {
    vec3 x = s.tangent, y = s.bitangent;
    if (!s.anisotropic) {
        x = normalize(abs(s.normal.y) < 0.9 ? vec3(s.normal.z, 0.0, -s.normal.x) : vec3(0.0, -s.normal.z, s.normal.y));
        y = cross(s.normal, x);
    }
    const vec3 eye = vec3(dot(x, v), dot(y, v), nv);
    SlopeEllipse e = slopes_of_disc(eye, vec3(dot(x, l), dot(y, l), nl), radius);
    e.center /= s.alphas;
    e.a /= s.alphas;
    e.b /= s.alphas;
    const vec3 found = form_factor(e);
    const vec3 h = normalize(vec3(found.xy * s.alphas, 1.0));
    const float vh = dot(eye, h);
    const vec3 mirrored = 2.0 * vh * h - eye;
    if (mirrored.z <= 0.0 || vh <= 0.0) return vec3(0.0);
    const float visibility = s.anisotropic ? stretched_smith_visibility(s.alphas, mirrored, eye)
                                           : smith_visibility(s.alpha, mirrored.z, nv);
    const float sine = sin(radius);
    const float facets = found.z / (kPi * sine * sine) * 4.0 * vh / h.z;
    return schlick(s.f0, s.f90, vh) * s.energy * (facets * visibility * mirrored.z);
}

// Returns the mean of the BRDF times n·l over the disc: the reflected radiance for unit irradiance on a plane that faces
// the disc. The middle of the disc must be above the horizon.
vec3 reflect_disc(Surface s, vec3 v, vec3 l, float radius) {
    const float nl = dot(s.normal, l);
    if (nl <= 0.0) return vec3(0.0);
    const float nv = max(dot(s.normal, v), 1e-4);
    const vec3 f = schlick(s.f0, s.f90, dot(v, normalize(v + l)));
    return base_under_coat(s, f) * (nl / kPi) + disc_specular(s, v, l, radius, nl, nv);
}
#endif
