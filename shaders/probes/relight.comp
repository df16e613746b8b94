// Lights the surfaces that a light probe sees: writes the radiance of each texel of its six faces, in cd/m². Surfaces
// reflect light evenly in all directions. Metals do, too: their highlights go in different directions, so that on
// average a probe receives the same light from them. A round of the group lights one probe.
#version 460
#include "area_lights.glsl"
#include "cube_texels.glsl"
#include "environment_cube.glsl"
#include "frame_set.glsl"
#include "lamp_share.glsl"
#include "light_function.glsl"
#include "lights.glsl"
#include "octahedral.glsl"
#include "probes.glsl"
#include "shared/probe_grid.glsl"
#include "shared/probe_sh.glsl"
#include "whole_shadow.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

// The light that surfaces reflect further: 0 none, 1 the light of the volume of probes, 2 that of this probe itself.
layout(constant_id = 1) const int probeFeedback = 1;

uniform sampler2DArray probeAlbedo, probeNormal, probeEmission;  // Six faces, as probeDistance of lamp_share.glsl.
uniform sampler2DArray probeSky;                                 // Surroundings / frame.environment_unit.
uniform sampler2DArrayShadow sceneSunShadow;
layout(std430) readonly buffer SceneLights { Light items[]; } sceneLights;
layout(std430) readonly buffer EnvironmentSh { vec4 items[]; } environmentSh;  // 4 or 9 coefficients, in cd/m².
layout(std430) readonly buffer ProbePoints { ProbePoint items[]; } probePoints;
layout(rgba32f) writeonly uniform image2DArray lit;
layout(push_constant) uniform Params { int p; } params;  // The number of the probe.

// Limits the light in a closed white room, if the probes never rest. A lookup is a mean of probes, so it adds no light of
// its own, and the sum of all reflections is at most 100 times the light of the first.
const float kMostAlbedo = 0.99;
const uint kThreads = 256u;

shared uint seen_lamps[kThreads / 32u];   // One bit for each lamp of the current chunk: the probe sees it.
shared float lamp_shares[kThreads];

struct Texel {
    vec3 position;
    vec3 to_probe;
    vec3 normal;
    vec3 albedo;
    vec3 emission;
    float width_m;  // Width of the texel at the surface.
};

Texel texel_at(uvec3 at, vec3 probe, float distance_m) {
    const float size = float(imageSize(lit).x);
    const vec3 direction = normalize(face_direction(at.z, face_position(at.xy, size)));
    Texel t;
    t.position = probe + direction * distance_m;
    t.to_probe = -direction;
    t.normal = octahedral_decode(texelFetch(probeNormal, ivec3(at), 0).rg);
    const vec3 root = texelFetch(probeAlbedo, ivec3(at), 0).rgb;
    t.albedo = root * root;
    t.emission = texelFetch(probeEmission, ivec3(at), 0).rgb / kProbeRadianceScale;
    t.width_m = distance_m * 2.0 / size;
    return t;
}

// Returns the irradiance of the directional lights.
vec3 sun_irradiance(Texel t) {
    const uint count = min(frame.directional_count, uint(sceneLights.items.length()));
    vec3 sum = vec3(0.0);
    for (uint i = 0u; i < count; ++i) {
        const Light light = sceneLights.items[i];
        const float cosine = -dot(t.normal, light.direction);
        if (cosine <= 0.0) continue;
        float visible = 1.0;
        if (light.shadow > 0u)
            visible = whole_visibility(sceneSunShadow, light.shadow - 1u, further_suns.scene[light.shadow - 1u],
                                       t.position, t.normal);
        if (visible <= 0.0) continue;
        sum += light.intensity * light_function(light, t.position, t.width_m) * (cosine * visible);
    }
    return sum;
}

vec3 lamp_irradiance(Light light, Texel t) {
    vec3 irradiance;
    if (light.type == kLightCapsule || light.type == kLightRectangle) {
        AreaIncident incident;
        if (light.type == kLightRectangle) {
            incident = rectangle_at(t.normal, t.normal, t.position, light);
        } else {
            incident = capsule_at(t.normal, t.normal, t.position, light);
        }
        irradiance = light.intensity * (incident.irradiance * incident.window);
    } else {
        const Incident incident = light_at(light, t.position);
        irradiance = incident.irradiance * max(dot(t.normal, incident.direction), 0.0);
    }
    if (irradiance == vec3(0.0)) return irradiance;
    return irradiance * light_function(light, t.position, t.width_m);
}

// Finds the lamps of a chunk that the probe sees. Each thread tests one lamp.
void find_lamps(uint first, uint count, vec3 probe) {
    const uint thread = gl_LocalInvocationIndex;
    barrier();
    if (thread < kThreads / 32u) seen_lamps[thread] = 0u;
    barrier();
    const float share = first + thread < count ? lamp_share(sceneLights.items[first + thread], probe) : 0.0;
    lamp_shares[thread] = share;
    if (share > 0.0) atomicOr(seen_lamps[thread / 32u], 1u << (thread % 32u));
    barrier();
}

// Adds the light of all lamps that the probe sees, always in the same order. Removes the emission of surfaces whose
// light is that of a lamp.
vec3 lamps_irradiance(inout Texel t, bool is_surface, vec3 probe) {
    const uint count = min(frame.light_count, uint(sceneLights.items.length()));
    vec3 sum = vec3(0.0);
    for (uint first = frame.directional_count; first < count; first += kThreads) {
        find_lamps(first, count, probe);
        if (!is_surface) continue;
        for (uint word = 0u; word < kThreads / 32u; ++word) {
            for (uint rest = seen_lamps[word]; rest != 0u; rest &= rest - 1u) {
                const uint i = word * 32u + uint(findLSB(rest));
                const Light light = sceneLights.items[first + i];
                sum += lamp_shares[i] * lamp_irradiance(light, t);
                if (t.emission != vec3(0.0) && is_on_lamp(light, t.position)) t.emission = vec3(0.0);
            }
        }
    }
    return sum;
}

// Returns irradiance / π of the light that other surfaces have reflected in the rounds before.
vec3 bounced_over_pi(Texel t) {
    if (probeFeedback == 0) return vec3(0.0);
    const float basis[9] = harmonic_basis(t.normal);
    vec3 sum = vec3(0.0);
    if (probeFeedback == 2) {
        for (uint i = 0u; i < 9u; ++i) sum += probeSh.items[uint(params.p) * kProbeShStride + i].rgb * basis[i];
        return max(sum, vec3(0.0));
    }
    // Places outside of the volume have the light of the surroundings. In the first rounds, some probes have no light
    // yet, and count as dark. So no light from elsewhere gets into closed rooms.
    const ProbeLight volume = probe_light(t.position, t.normal, t.to_probe, t.normal);
    const vec3 known = volume.facing * volume.validity;
    if (volume.outside <= 0.0) return known;
    const int terms = min(environmentSh.items.length(), 9);
    for (int i = 0; i < terms; ++i) sum += environmentSh.items[i].rgb * basis[i];
    return known + max(sum, vec3(0.0)) * volume.outside;
}

void main() {
    const uvec3 at = gl_GlobalInvocationID;
    const bool inside = all(lessThan(at, uvec3(imageSize(lit))));
    const vec3 probe = probePoints.items[params.p].position;
    const float distance_m = inside ? texelFetch(probeDistance, ivec3(at), 0).r : 0.0;
    const bool is_surface = distance_m > 0.0;
    Texel t;
    if (is_surface) t = texel_at(at, probe, distance_m);
    const vec3 from_lamps = lamps_irradiance(t, is_surface, probe);
    if (!inside) return;
    vec3 radiance = vec3(0.0);  // The back of a surface is dark.
    if (is_surface) {
        radiance = t.emission + t.albedo * ((sun_irradiance(t) + from_lamps) / kPi) +
                   min(t.albedo, vec3(kMostAlbedo)) * bounced_over_pi(t);
    } else if (distance_m == 0.0) {
        radiance = texelFetch(probeSky, ivec3(at), 0).rgb * frame.environment_unit;
    }
    imageStore(lit, ivec3(at), vec4(radiance, 1.0));
}
