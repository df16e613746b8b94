// Makes the octahedral map of what a probe sees, with which lookups find out whether the probe sees a point. The inverse
// distance is 0 where nothing is. On a plane it is the product of the direction and a vector: the normal divided by the
// distance of the plane from the probe. So each texel gets the plane that fits best to what is seen within it. rgb: the
// vector, in 1/m; a: standard deviation of the inverse distance from this plane. A wall has nearly no deviation and the
// same vector everywhere, even where the probe sees it at a grazing angle. The map has 16 × 16 texels and a border of
// one texel, which continues the map, so that a linear filter works across its edges.
#version 460
#include "cube_texels.glsl"
#include "octahedral.glsl"
#include "probe_map.glsl"

layout(local_size_x = 9, local_size_y = 9) in;

uniform sampler2DArray faces;
layout(rgba16f) writeonly uniform image2D moments;

const int kSide = int(kProbeMomentSide);
const int kSamples = 8;  // Per side of a texel. A texel has the size of about 5 × 5 texels of a face with 32 × 32.

// Returns the texel of the map whose content a texel has. Texels of the border are copies.
ivec2 wrapped(ivec2 at) {
    if (at.x < 0 || at.x >= kSide) at = ivec2(clamp(at.x, 0, kSide - 1), kSide - 1 - at.y);
    if (at.y < 0 || at.y >= kSide) at = ivec2(kSide - 1 - at.x, clamp(at.y, 0, kSide - 1));
    return at;
}

// Returns the inverse distance in the texel of the faces at a direction. The direction becomes that of the middle of
// this texel.
float inverse_distance(inout vec3 direction) {
    const int size = textureSize(faces, 0).x;
    vec2 at;
    const uint face = face_of_direction(direction, at);
    const ivec2 texel = min(ivec2((at * 0.5 + 0.5) * float(size)), size - 1);
    direction = normalize(face_direction(face, face_position(uvec2(texel), float(size))));
    const float distance = abs(texelFetch(faces, ivec3(texel, face), 0).r);
    return distance > 0.0 ? 1.0 / distance : 0.0;
}

// Returns the point of the octahedron for a position in the map, in texels. The map is an octahedron laid flat.
vec3 octahedron_point(vec2 position) {
    const vec2 e = position / float(kSide) * 2.0 - 1.0;
    vec3 point = vec3(e, 1.0 - abs(e.x) - abs(e.y));
    if (point.z < 0.0) point.xy = (1.0 - abs(point.yx)) * sign_not_zero(point.xy);
    return point;
}

void main() {
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, imageSize(moments)))) return;
    const vec2 texel = vec2(wrapped(at - 1));
    // Sums of the least squares: inverse distance ≈ plane · direction.
    mat3 squares = mat3(0.0);
    vec3 products = vec3(0.0);
    float nears = 0.0, weights = 0.0;
    for (int i = 0; i < kSamples * kSamples; ++i) {
        const vec3 point = octahedron_point(texel + (vec2(i % kSamples, i / kSamples) + 0.5) / float(kSamples));
        // A piece of the octahedron looks smaller from its middle where it is farther away.
        const float inverse_length = inversesqrt(dot(point, point));
        const float weight = inverse_length * inverse_length * inverse_length;
        vec3 direction = point * inverse_length;
        const float near = inverse_distance(direction);
        squares += weight * outerProduct(direction, direction);
        products += weight * near * direction;
        nears += weight * near * near;
        weights += weight;
    }
    const vec3 plane = inverse(squares) * products;
    const float variance = max(nears - dot(plane, products), 0.0) / weights;
    imageStore(moments, at, vec4(plane, sqrt(variance)));
}
