// Reads the image `lightBounds`, which light_bounds.glsl describes. Requires light_bounds.glsl and reach.glsl.

vec4 sphere_of(uint light) { return texelFetch(lightBounds, bounds_texel(light), 0); }

Reach reach_of(uint light) {
    const ivec2 at = bounds_texel(light);
    const vec4 a = texelFetch(lightBounds, at + ivec2(0, 1), 0), b = texelFetch(lightBounds, at + ivec2(0, 2), 0);
    const vec4 c = texelFetch(lightBounds, at + ivec2(0, 3), 0), d = texelFetch(lightBounds, at + ivec2(0, 4), 0);
    return Reach(a.xyz, a.w, b.xyz, b.w, c.xyz, d.w, d.xyz, c.w);
}
