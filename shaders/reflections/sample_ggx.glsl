// Directions in which a rough surface (GGX) mirrors the eye, with the density of the visible normals. Only directions
// above the surface are likely. Source: Eto and Tokuyoshi 2023, "Bounded VNDF Sampling for Smith-GGX Reflections".
#ifndef WEFT_SAMPLE_GGX
#define WEFT_SAMPLE_GGX

// Returns two unit vectors that are perpendicular to `n` and to each other. Source: Duff et al. 2017, "Building an
// Orthonormal Basis, Revisited".
mat3 basis_around(vec3 n) {
    const float side = n.z < 0.0 ? -1.0 : 1.0;
    const float a = -1.0 / (side + n.z), b = n.x * n.y * a;
    return mat3(vec3(1.0 + side * n.x * n.x * a, side * b, -side * n.x), vec3(b, side + n.y * n.y * a, -n.y), n);
}

// Returns by how much the sphere of normals is cut: the lowest z of the sphere is −bound · v.z / |stretched v|.
float bound_of_normals(vec3 v, float alpha) {
    const float s = 1.0 + length(v.xy), a2 = alpha * alpha, s2 = s * s;
    return (1.0 - a2) * s2 / (s2 + a2 * v.z * v.z);
}

// Returns the mirrored direction for two random numbers. `v`: direction to the eye. All directions in the space of the
// surface, in which the normal is z. The result can be below the surface.
vec3 sample_mirrored(vec3 v, float alpha, vec2 random) {
    const vec3 stretched = normalize(vec3(alpha * v.xy, v.z));
    const float turn = 6.28318531 * random.x, low = bound_of_normals(v, alpha) * stretched.z;
    const float z = (1.0 - random.y) * (1.0 + low) - low;
    const vec2 xy = sqrt(clamp(1.0 - z * z, 0.0, 1.0)) * vec2(cos(turn), sin(turn));
    const vec3 middle = stretched + vec3(xy, z);
    const vec3 h = normalize(vec3(alpha * middle.xy, middle.z));
    return 2.0 * dot(v, h) * h - v;
}

// Returns the density in 1/sr with which sample_mirrored() gives a direction. `distribution`: GGX distribution of the
// normal halfway between `v` and the direction.
float mirrored_density(vec3 v, float alpha, float distribution) {
    const vec2 flat_v = alpha * v.xy;
    const float lengthened = sqrt(dot(flat_v, flat_v) + v.z * v.z);
    return distribution / (2.0 * (bound_of_normals(v, alpha) * v.z + lengthened));
}
#endif
