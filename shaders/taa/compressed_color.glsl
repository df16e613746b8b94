// Converts colours to YCoCg and compresses them to a range below 1, so that a highlight does not dominate the dark
// colours around it. Sources: Malvar and Sullivan 2003, "YCoCg-R: A Color Space with RGB Reversibility"; Karis 2014,
// "High-Quality Temporal Supersampling".

vec3 compressed(vec3 color) {
    const float y = dot(color, vec3(0.25, 0.5, 0.25));
    const vec3 ycocg = vec3(y, dot(color, vec3(0.5, 0.0, -0.5)), dot(color, vec3(-0.25, 0.5, -0.25)));
    return ycocg / (1.0 + y);
}

vec3 expanded(vec3 ycocg) {
    const vec3 c = ycocg / max(1.0 - ycocg.x, 1e-4);
    return vec3(c.x + c.y - c.z, c.x + c.z, c.x - c.y - c.z);
}
