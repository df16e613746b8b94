// Reflection of light by surfaces with metalness and roughness. Units: 1/sr. Microfacets: Trowbridge–Reitz (GGX) with
// height-correlated Smith masking-shadowing, Heitz 2014, "Understanding the Masking-Shadowing Function in
// Microfacet-Based BRDFs". Fresnel: Schlick 1994. A dielectric coat lies over a diffuse base; see base_under_coat().
#ifndef WEFT_BRDF
#define WEFT_BRDF

const float kPi = 3.14159265358979;

// Properties of a surface at a point, in the form that the loops over lights need.
struct Surface {
    vec3 normal;
    vec3 diffuse;     // Albedo of the diffuse base; black for metals.
    vec3 f0;
    float f90;
    float alpha;      // Squared perceptual roughness (the α of GGX).
    bool anisotropic; // True if the highlight is longer in one direction. If false, the next three members are unused.
    vec3 tangent;     // Direction in which the highlight is longer, perpendicular to the normal.
    vec3 bitangent;
    vec2 alphas;      // α along the tangent and along the bitangent.
    vec2 albedo;      // Directional albedo of the specular reflection towards the eye: factors of F0 and of F90.
    bool under_coat;  // True if a clear coat lies over the surface. Then the reflections of the screen are those of the coat.
    vec2 oren_nayar;  // A and B of the diffuse reflection; see diffuse_factor().
    vec3 energy;      // Factor for the specular reflection, for light that microfacets reflect several times.
};

// Smallest α. With a smaller α, the highlight of a point light could be smaller than a pixel and overflow half floats.
const float kMinAlpha = 0.002;

Surface make_surface(vec3 normal, vec3 base_color, float metallic, float roughness, vec3 dielectric_f0, float specular) {
    Surface s;
    s.normal = normal;
    s.diffuse = base_color * (1.0 - metallic);
    s.f0 = mix(dielectric_f0 * specular, base_color, metallic);
    s.f90 = mix(specular, 1.0, metallic);
    s.alpha = max(roughness * roughness, kMinAlpha);
    s.anisotropic = false;
    s.tangent = s.bitangent = vec3(0.0);
    s.alphas = vec2(s.alpha);
    s.albedo = vec2(0.0);  // with_albedo() of dfg.glsl sets `albedo` and `energy`.
    s.energy = vec3(1.0);
    s.under_coat = false;
    s.oren_nayar = vec2(1.0, 0.0);
    return s;
}

// Returns the surface with more roughness along `tangent`, which has unit length and is perpendicular to the normal.
// `strength` is 0 to 1. Source: KHR_materials_anisotropy.
Surface stretched(Surface s, vec3 tangent, float strength) {
    s.anisotropic = true;
    s.tangent = tangent;
    s.bitangent = cross(s.normal, tangent);
    s.alphas.x = mix(s.alpha, 1.0, strength * strength);
    return s;
}

// Returns the share of uniform light that the surface mirrors to the eye. with_albedo() of dfg.glsl must have set
// `s.albedo` and `s.energy`.
vec3 mirrored_share(Surface s) { return (s.f0 * s.albedo.x + s.f90 * s.albedo.y) * s.energy; }

// Returns the GGX distribution D. 1 − (n·h)² is computed as |n × h|², which is more precise for narrow highlights.
float ggx_distribution(float alpha, vec3 n, vec3 h) {
    const vec3 c = cross(n, h);
    const float a2 = alpha * alpha;
    const float nh = dot(n, h);
    const float d = dot(c, c) + nh * nh * a2;
    return a2 / (kPi * d * d);
}

// Returns the visibility V = G2 / (4 · n·l · n·v), with G2 the masking-shadowing function.
float smith_visibility(float alpha, float nl, float nv) {
    const float a2 = alpha * alpha;
    const float lambda_v = nl * sqrt(nv * nv * (1.0 - a2) + a2);
    const float lambda_l = nv * sqrt(nl * nl * (1.0 - a2) + a2);
    return 0.5 / max(lambda_v + lambda_l, 1e-7);
}

// Returns the GGX distribution D of an anisotropic surface. The components of `h` are along tangent, bitangent and
// normal. Sources: Burley 2012, "Physically-Based Shading at Disney"; Heitz 2014.
float stretched_ggx_distribution(vec2 alphas, vec3 h) {
    const vec3 flattened = vec3(h.xy / alphas, h.z);
    const float d = dot(flattened, flattened);
    return 1.0 / (kPi * alphas.x * alphas.y * d * d);
}

float stretched_smith_visibility(vec2 alphas, vec3 l, vec3 v) {
    const float lambda_v = l.z * length(vec3(alphas * v.xy, v.z));
    const float lambda_l = v.z * length(vec3(alphas * l.xy, l.z));
    return 0.5 / max(lambda_v + lambda_l, 1e-7);
}

float stretched_specular(Surface s, vec3 v, vec3 l, vec3 h, float nl, float nv) {
    const mat3 to_surface = transpose(mat3(s.tangent, s.bitangent, s.normal));
    return stretched_ggx_distribution(s.alphas, to_surface * h) *
           stretched_smith_visibility(s.alphas, vec3((to_surface * l).xy, nl), vec3((to_surface * v).xy, nv));
}

// Returns a normal for reflecting the sky on an anisotropic surface. An isotropic mirror with this normal reflects
// along the middle of the anisotropic highlight. Source: McAuley 2015, "Rendering the World of Far Cry 4".
vec3 bent_normal(Surface s, vec3 v, float roughness) {
    const float strength = sqrt(clamp((s.alphas.x - s.alpha) / max(1.0 - s.alpha, 1e-4), 0.0, 1.0));
    const float straight = 1.0 - strength * (1.0 - roughness);
    const float straight2 = straight * straight;
    const vec3 bent = cross(cross(s.bitangent, v), s.bitangent);
    return normalize(mix(bent, s.normal, straight2 * straight2));
}

vec3 schlick(vec3 f0, float f90, float vh) {
    const float m = clamp(1.0 - vh, 0.0, 1.0);
    const float m2 = m * m;
    return f0 + (vec3(f90) - f0) * (m2 * m2 * m);
}

// Returns the share of light that the diffuse base sends back through the coat. `coat` is the share that the coat itself
// reflects. The base colour of a material is this share, because a base colour is measured or painted as it looks through
// the coat. So the coat does not darken a dark base. But a surface cannot reflect more light than it receives, so the
// share is at most the light that the coat lets through. glTF 2.0 (Appendix B) multiplies the base by 1 − F instead, so
// dark bases become darker than their base colour. For white bases, both rules give the same result.
vec3 base_under_coat(Surface s, vec3 coat) {
    return min(s.diffuse, vec3(max(1.0 - max(coat.r, max(coat.g, coat.b)), 0.0)));
}

// Returns the diffuse reflection divided by that of an ideally diffuse surface. A rough surface reflects more light back
// to where it comes from. Source: Oren and Nayar 1994, "Generalization of Lambert's Reflectance Model", the qualitative
// model. `nl`, `nv`: cosines of the angles from the normal to the light and to the eye.
float diffuse_factor(Surface s, vec3 v, vec3 l, float nl, float nv) {
    const float across = dot(v, l) - nl * nv;  // sin θl · sin θv · cos Δφ
    const float sine = across > 0.0 ? across / max(max(nl, nv), 1e-4) : 0.0;  // sin of the larger · tan of the smaller
    return s.oren_nayar.x + s.oren_nayar.y * sine;
}

// Returns the BRDF times n·l: the reflected radiance for unit irradiance on a plane that faces the light.
vec3 reflect_light(Surface s, vec3 v, vec3 l) {
    const float nl = dot(s.normal, l);
    if (nl <= 0.0) return vec3(0.0);
    const float nv = max(dot(s.normal, v), 1e-4);
    const vec3 h = normalize(v + l);
    const vec3 f = schlick(s.f0, s.f90, dot(v, h));
    const float specular = s.anisotropic
                               ? stretched_specular(s, v, l, h, nl, nv)
                               : ggx_distribution(s.alpha, s.normal, h) * smith_visibility(s.alpha, nl, nv);
    vec3 base = base_under_coat(s, f) / kPi;
    if (s.oren_nayar.y > 0.0) base *= diffuse_factor(s, v, l, nl, nv);
    return (base + f * s.energy * specular) * nl;
}
#endif
