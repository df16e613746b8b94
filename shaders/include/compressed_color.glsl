// Compresses each channel to a range below 1, about as the tone curve does, and converts the result to YCoCg. So the mean
// of several colours is close to the mean that the eye sees, and a highlight does not dominate the dark colours around it.
// Sources: Malvar and Sullivan 2003, "YCoCg-R: A Color Space with RGB Reversibility"; Karis 2014, "High-Quality Temporal
// Supersampling".
#ifndef WEFT_COMPRESSED_COLOR
#define WEFT_COMPRESSED_COLOR

// A channel with this value becomes 0.5. The unit is white in the final picture.
const float kCompressedHalf = 0.5;

vec3 compressed(vec3 color) {
    const vec3 c = color / (color + kCompressedHalf);
    return vec3(dot(c, vec3(0.25, 0.5, 0.25)), dot(c, vec3(0.5, 0.0, -0.5)), dot(c, vec3(-0.25, 0.5, -0.25)));
}

vec3 expanded(vec3 ycocg) {
    const vec3 c = vec3(ycocg.x + ycocg.y - ycocg.z, ycocg.x + ycocg.z, ycocg.x - ycocg.y - ycocg.z);
    const vec3 inside = clamp(c, vec3(0.0), vec3(0.9999));
    return kCompressedHalf * inside / (1.0 - inside);
}
#endif
