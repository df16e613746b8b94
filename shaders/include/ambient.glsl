// The light of the surroundings that a surface reflects (ambient light). Units: cd/m². Ports, all optional: those of
// environment_light.glsl, `dfg` of graphs/modules/dfg.json, and those of probes.glsl and reflection_probes.glsl. With
// `probeSh`, the light comes from the probes around the point. With the port `nearField` of near_field.glsl, objects
// near the point block a part of this light, and reflect their own light to the point. With the port `ssr` of
// screen_reflections.glsl, mirrored light comes from the picture of the previous frame where this picture shows the
// mirrored objects.
#ifndef WEFT_AMBIENT
#define WEFT_AMBIENT
#include "brdf.glsl"
#include "dfg.glsl"
#include "environment_light.glsl"
#include "frame_set.glsl"
#include "mirror_lobe.glsl"
#include "near_field.glsl"
#include "probes.glsl"
#include "reflection_probes.glsl"
#include "screen_reflections.glsl"

// Returns the middle of the directions from which a surface with this roughness reflects light. `mirrored` is the
// direction in which a smooth surface mirrors the sky. The middle for a rough surface is nearer to the normal: Lagarde
// and de Rousiers 2014, "Moving Frostbite to Physically Based Rendering".
vec3 middle_of_lobe(vec3 mirrored, vec3 n, float roughness) {
    const float alpha = roughness * roughness;
    return normalize(mix(n, mirrored, (1.0 - alpha) * (sqrt(1.0 - alpha) + alpha)));
}

// Returns the mean radiance that a surface with this roughness mirrors. `mirrored` is the direction in which a smooth
// surface mirrors the sky. mirror_parts() in mirror_lobe.glsl describes the three parts of the sum.
vec3 mirrored_radiance(vec3 mirrored, vec3 n, float roughness) {
    if (!HAS_environmentCube) return blurred_radiance(mirrored, n, roughness);
    const float nv = clamp(dot(n, mirrored), 0.0, 1.0);
    const MirrorParts parts = mirror_parts(roughness, nv);
    const vec3 down = mirrored * dot(n, mirrored) - n;
    vec3 sum = vec3(0.0);
    const int count = roughness > kLeastParted ? 3 : 1;
    for (int i = 0; i < count; ++i)
        sum += (count == 1 ? 1.0 : kPartShares[i]) *
               filtered_radiance(normalize(mirrored + down * parts.tilts[i]), parts.roughnesses[i]);
    return sum;
}

// The light of the surroundings on a surface: irradiance / π, and the mean radiance that the surface mirrors.
struct AmbientLight {
    vec3 diffuse, mirrored;
};

// Returns the largest factor by which probes change the sky that a surface mirrors. The factor is above 1 if the
// surfaces around the point are brighter than the sky, but a smooth surface that mirrors the sky mirrors none of their
// light.
float brightest_change(float roughness) { return mix(1.0, 2.0, smoothstep(0.3, 0.6, roughness)); }

// Replaces mirrored light by the light of the reflection probes around a point, if the probes see the surfaces that the
// point mirrors. `here`: irradiance / π at the point, for a normal in the middle of the mirrored directions. A rough
// surface mirrors light from many directions, and a probe at another place receives more or less of this light. So the
// light of a probe is multiplied by the irradiance at the point and divided by the irradiance at the probe. Where the
// probes see the sky, the mirrored light is `sky`, the best known light of the surroundings. If there is a filtered
// cube, `sky` is multiplied by the light of the probes and divided by the light of the cube.
vec3 with_reflection_probes(vec3 light, vec3 sky, vec3 position, vec3 middle, float roughness, vec3 here,
                            float free_m) {
    const ReflectionLight seen = reflection_light(position, middle, roughness, free_m);
    const vec3 change = clamp(here / max(seen.irradiance_over_pi, vec3(1e-9)), 0.0, 2.0);
    const vec3 radiance = seen.radiance * mix(vec3(1.0), change, smoothstep(0.1, 0.3, roughness));
    vec3 open = sky;
    if (HAS_environmentCube) {
        const vec3 cube = max(filtered_radiance(middle, roughness), vec3(1e-9));
        open *= clamp(seen.radiance / cube, 0.0, brightest_change(roughness));
    }
    return mix(light, mix(radiance, open, seen.sky), seen.share);
}

// Length of the longest vector of probe_aside() along an axis: nearly the width of a texel of the map of a probe.
const float kProbeAside = 0.08;

// Returns a vector by which a probe looks beside a point (ProbeQuery). The map of a probe has few texels, and the light of
// a probe ends at their edges. With temporal anti-aliasing, which blends frames, each pixel has another vector in each
// frame, so that such edges are soft. Without it (view.mip_bias is 0), the vector is 0. Sources: Jimenez 2014, "Next
// Generation Post Processing in Call of Duty: Advanced Warfare" (noise); Roberts 2018, "The Unreasonable Effectiveness of
// Quasirandom Sequences" (steps from frame to frame).
vec3 probe_aside(ivec2 pixel) {
    if (view.mip_bias >= 0.0) return vec3(0.0);
    const float noise = fract(52.9829189 * fract(dot(vec2(0.06711056, 0.00583715), vec2(pixel))));
    const vec3 steps = vec3(0.8191725, 0.6710436, 0.5497005) * float(frame.frame_index % 1024u);
    return kProbeAside * (2.0 * fract(noise * vec3(1.0, 7.13, 51.3) + steps) - 1.0);
}

// Replaces the light of the whole surroundings by the light of the probes around a point. Irradiance probes contain
// only diffuse light. So where there is no light from a reflection probe, the mirrored light is multiplied by a
// factor: the irradiance from the mirrored directions with the probes, divided by this irradiance without the probes.
// This also darkens reflections where the sky is hidden. A very rough surface mirrors the same light that a diffuse
// surface reflects. `open`: mean direction from which diffuse light arrives. `free_m`: for this distance, nothing is
// in the way of the mirrored direction. `aside`: see probe_aside().
AmbientLight with_probes(AmbientLight light, vec3 position, vec3 n, vec3 open, vec3 v, vec3 mirrored, float roughness,
                         float free_m, vec3 aside) {
    const vec3 middle = middle_of_lobe(mirrored, n, roughness);
    const ProbeLight probes = probe_light(position, n, v, open, middle, aside);
    const vec3 sky = max(sky_irradiance_over_pi(middle), vec3(1e-9));
    const vec3 change = clamp(probes.mirrored / sky, 0.0, brightest_change(roughness));
    const float very_rough = clamp(lod_of_roughness(roughness) - kLastFiltered, 0.0, 1.0);
    vec3 near = light.mirrored * change;
    if (HAS_reflectionCubes && very_rough < 1.0)
        near = with_reflection_probes(near, light.mirrored, position, middle, roughness, probes.mirrored, free_m);
    near = mix(near, probes.mirrored, very_rough);
    return AmbientLight(mix(light.diffuse, probes.facing, probes.validity), mix(light.mirrored, near, probes.validity));
}

// Adds near objects to the light of the surroundings on a surface: the objects block a part of this light, and the
// light that they reflect themselves replaces this part.
AmbientLight with_near_field(AmbientLight light, NearField near, vec3 n, vec3 mirrored, float roughness) {
    const vec3 near_radiance = near.light / max(1.0 - near.visibility, 1e-3);
    const float open = near_specular_visibility(near, n, mirrored, roughness);
    return AmbientLight(light.diffuse * near.visibility + near.light, mix(near_radiance, light.mirrored, open));
}

// Returns the reflection of the surroundings. with_albedo() must have set `s.albedo` and `s.energy`. An anisotropic
// surface reflects the sky like an isotropic surface whose highlight has the same brightness in its middle. `pixel`:
// the pixel of the surface.
vec3 ambient_reflection(Surface s, vec3 v, float roughness, vec3 position, ivec2 pixel) {
    const vec3 specular = mirrored_share(s);
    const vec3 across = s.anisotropic ? bent_normal(s, v, roughness) : s.normal;
    const float blur = s.anisotropic ? sqrt(sqrt(s.alphas.x * s.alphas.y)) : roughness;
    const vec3 mirrored = reflect(-v, across);
    NearField near = NearField(s.normal, vec3(0.0), 1.0);
    if (HAS_nearField) near = near_field_at(pixel, position, s.normal);
    ScreenReflection seen = ScreenReflection(vec4(0.0), vec3(0.0), 0.0);
    if (HAS_ssr && !s.under_coat) seen = screen_reflection(pixel, position, s.normal);
    AmbientLight light = AmbientLight(sky_irradiance_over_pi(near.open), seen.open);
    // The rays are those of an isotropic surface. Those of a mirror give the same light, but are fewer than the pixels.
    if (seen.free_m <= 0.0 || s.alpha < kMirrorAlpha || s.anisotropic)
        light.mirrored = mirrored_radiance(mirrored, s.normal, blur);
    if (HAS_probeSh)
        light = with_probes(light, position, s.normal, normalize(s.normal + near.open), v, mirrored, blur, seen.free_m,
                            probe_aside(pixel));
    const vec3 far = light.mirrored;
    if (HAS_nearField) light = with_near_field(light, near, s.normal, mirrored, blur);
    // The rays without a hit have already found that no near object is in their way.
    if (seen.free_m > 0.0) light.mirrored = far;
    if (HAS_ssr && !s.under_coat) light.mirrored = light.mirrored * (1.0 - seen.light.a) + seen.light.rgb;
    return base_under_coat(s, specular) * light.diffuse + specular * light.mirrored;
}
#endif
