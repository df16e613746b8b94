// Directions and solid angles of the texels of a cube map. The faces are in the order +x −x +y −y +z −z.
#ifndef WEFT_CUBE_TEXELS
#define WEFT_CUBE_TEXELS

// Returns the direction of a point of a face; `at` is from −1 to 1. The point lies on a cube with sides of length 2.
vec3 face_direction(uint face, vec2 at) {
    switch (face) {
        case 0u: return vec3(1.0, -at.y, -at.x);
        case 1u: return vec3(-1.0, -at.y, at.x);
        case 2u: return vec3(at.x, 1.0, at.y);
        case 3u: return vec3(at.x, -1.0, -at.y);
        case 4u: return vec3(at.x, -at.y, 1.0);
        default: return vec3(-at.x, -at.y, -1.0);
    }
}

// Returns the face that a direction meets, and in `at` the position on this face, from −1 to 1.
uint face_of_direction(vec3 d, out vec2 at) {
    const vec3 size = abs(d);
    if (size.x >= size.y && size.x >= size.z) {
        at = vec2(d.x > 0.0 ? -d.z : d.z, -d.y) / size.x;
        return d.x > 0.0 ? 0u : 1u;
    }
    if (size.y >= size.z) {
        at = vec2(d.x, d.y > 0.0 ? d.z : -d.z) / size.y;
        return d.y > 0.0 ? 2u : 3u;
    }
    at = vec2(d.z > 0.0 ? d.x : -d.x, -d.y) / size.z;
    return d.z > 0.0 ? 4u : 5u;
}

// Returns the position of the middle of a texel on its face.
vec2 face_position(uvec2 texel, float size) { return (vec2(texel) * 2.0 + 1.0) / size - 1.0; }

// Returns the solid angle of a texel in steradians, by Gauss's formula with 2 × 2 points. Largest relative error for a
// face of 8 × 8 texels: 3 · 10⁻⁵. The exact formula, a sum of four arctangents, has a larger rounding error for small
// texels.
float texel_solid_angle(vec2 middle, float size) {
    const float step = 0.57735027 / size;
    float sum = 0.0;
    for (int i = 0; i < 4; ++i) {
        const vec2 at = middle + step * vec2((i & 1) * 2 - 1, (i >> 1) * 2 - 1);
        const float inverse = inversesqrt(1.0 + dot(at, at));
        sum += inverse * inverse * inverse;
    }
    return sum / (size * size);
}
#endif
