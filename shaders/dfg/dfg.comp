// Writes the table of directional albedo that include/dfg.glsl reads. Each element is an integral over the microfacets
// that the viewer sees: Heitz 2018, "Sampling the GGX Distribution of Visible Normals". The samples are a grid on the
// projected hemisphere. The steps of the radius become smaller towards the rim, because there a small step changes the
// angle much. Half of the hemisphere is enough, because the other half is its mirror image. Largest error of an
// integral: 0.0006.
#version 460
layout(local_size_x = 8, local_size_y = 8) in;

#include "dfg_table.glsl"

layout(std430) writeonly buffer Dfg { uvec2 items[]; } dfg;
layout(push_constant) uniform Params { float multipleScattering; } params;

const int kRadii = 48, kAngles = 6;
const float kPi = 3.14159265;
const float kMinAlpha = 0.002;  // As in brdf.glsl.

float smith_lambda(float alpha, float cosine) {
    const float tan2 = (1.0 - cosine * cosine) / (cosine * cosine);
    return 0.5 * sqrt(1.0 + alpha * alpha * tan2) - 0.5;
}

// Returns the visible microfacet normal for the point (x, y) of the unit disc.
vec3 visible_normal(vec2 at, vec3 stretched, float alpha) {
    const float s = 0.5 * (1.0 + stretched.z);
    const float rest = max(1.0 - at.x * at.x, 0.0);
    const float y = mix(sqrt(rest), at.y, s);
    const float z = sqrt(max(rest - y * y, 0.0));
    const vec3 h = at.x * vec3(0.0, 1.0, 0.0) + y * vec3(-stretched.z, 0.0, stretched.x) + z * stretched;
    return normalize(vec3(alpha * h.xy, max(h.z, 1e-6)));
}

void main() {
    const uvec2 at = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(at, uvec2(kDfgSide)))) return;
    const vec2 place = vec2(at) / float(kDfgSide - 1u);
    const float nv = max(place.x * place.x, 1e-3), alpha = max(place.y * place.y, kMinAlpha);
    const vec3 v = vec3(sqrt(1.0 - nv * nv), 0.0, nv);
    const vec3 stretched = normalize(vec3(alpha * v.x, 0.0, v.z));
    const float lambda_v = smith_lambda(alpha, nv);
    vec2 sum = vec2(0.0);
    float weights = 0.0;
    for (int i = 0; i < kRadii; ++i) {
        // The samples have equal distances in t. The square of the radius is 1 − t^2.5. The weight of a sample is the
        // derivative of this square by t, without its constant factor −2.5.
        const float t = 1.0 - (float(i) + 0.5) / float(kRadii), root = sqrt(t);
        const float radius = sqrt(1.0 - t * t * root), weight = t * root;
        for (int k = 0; k < kAngles; ++k) {
            const float angle = kPi * ((float(k) + 0.5) / float(kAngles) - 0.5);
            const vec3 h = visible_normal(radius * vec2(cos(angle), sin(angle)), stretched, alpha);
            const float vh = dot(v, h), nl = 2.0 * vh * h.z - nv;
            weights += weight;
            if (nl <= 0.0 || vh <= 0.0) continue;
            const float seen = (1.0 + lambda_v) / (1.0 + lambda_v + smith_lambda(alpha, min(nl, 1.0)));
            const float away = clamp(1.0 - vh, 0.0, 1.0), away2 = away * away, fresnel = away2 * away2 * away;
            sum += weight * seen * vec2(1.0 - fresnel, fresnel);
        }
    }
    dfg.items[at.y * kDfgSide + at.x] = packed_dfg(vec3(sum / weights, params.multipleScattering));
}
