// Stores a unit vector in two components (octahedral encoding). Source: Cigolle et al. 2014, "A Survey of Efficient
// Representations for Independent Unit Vectors". With snorm16 components, the largest error is 0.0037°.
#ifndef WEFT_OCTAHEDRAL
#define WEFT_OCTAHEDRAL

vec2 sign_not_zero(vec2 v) { return vec2(v.x >= 0.0 ? 1.0 : -1.0, v.y >= 0.0 ? 1.0 : -1.0); }

vec2 octahedral_encode(vec3 n) {
    const vec2 p = n.xy / (abs(n.x) + abs(n.y) + abs(n.z));
    return n.z >= 0.0 ? p : (1.0 - abs(p.yx)) * sign_not_zero(p);
}

vec3 octahedral_decode(vec2 e) {
    vec3 n = vec3(e, 1.0 - abs(e.x) - abs(e.y));
    if (n.z < 0.0) n.xy = (1.0 - abs(n.yx)) * sign_not_zero(n.xy);
    return normalize(n);
}
#endif
