// Lights the surfaces that a light probe sees: writes the radiance of each texel of its six faces, in cd/m². Surfaces
// reflect light evenly in all directions. Metals do, too: their highlights go in different directions, so that on
// average a probe receives the same light from them. Each round of the group of passes lights one probe.
//
// Each thread lights a block of texels: it computes the incident light once, for one texel of the block. The texels of
// the block have an albedo and an emission of their own.
#version 460
#include "area_lights.glsl"
#include "cube_texels.glsl"
#include "environment_cube.glsl"
#include "frame_set.glsl"
#include "lamp_share.glsl"
#include "light_function.glsl"
#include "lights.glsl"
#include "octahedral.glsl"
#include "probe_lamps.glsl"
#include "probes.glsl"
#include "shared/probe_grid.glsl"
#include "shared/probe_sh.glsl"
#include "whole_shadow.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

// Selects the light of other surfaces that a surface reflects again. 0: none, 1: the light of the volume of probes, 2:
// the light of this probe itself.
layout(constant_id = 1) const int probeFeedback = 1;
// Texels along each side of a block. The faces have a whole number of blocks.
layout(constant_id = 2) const int blockSide = 1;

// Six layers, one for each face, like probeDistance of lamp_share.glsl.
uniform sampler2DArray probeAlbedo, probeNormal, probeEmission;
// Light of the surroundings, divided by frame.environment_unit.
uniform sampler2DArray probeSky;
uniform sampler2DArrayShadow sceneSunShadow;
layout(std430) readonly buffer SceneLights { Light items[]; } sceneLights;
// 4 or 9 coefficients of spherical harmonics, in cd/m².
layout(std430) readonly buffer EnvironmentSh { vec4 items[]; } environmentSh;
layout(std430) readonly buffer ProbePoints { ProbePoint items[]; } probePoints;
layout(std430) readonly buffer Lamps { uint items[]; } lamps;
layout(rgba32f) writeonly uniform image2DArray lit;
layout(push_constant) uniform Params { int p; } params;  // The number of the probe.

// Largest albedo for light that other surfaces have reflected. This limit matters in a closed white room, where each
// new round of lighting the probes adds light. A lookup is a mean of probes and adds no light. So the sum of all
// reflections is at most 1 / (1 − 0.99) = 100 times the light of the first reflection.
const float kMostAlbedo = 0.99;
struct Texel {
    vec3 position;
    vec3 to_probe;
    vec3 normal;
    float width_m;  // Width of the texel at the surface.
};

Texel texel_at(ivec3 at, vec3 probe, float distance_m) {
    const float size = float(imageSize(lit).x);
    const vec3 direction = normalize(face_direction(uint(at.z), face_position(uvec2(at.xy), size)));
    Texel t;
    t.position = probe + direction * distance_m;
    t.to_probe = -direction;
    t.normal = octahedral_decode(texelFetch(probeNormal, at, 0).rg);
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

// Returns the irradiance of all lamps that the probe sees, always added in the same order.
vec3 lamps_irradiance(Texel t) {
    const uint count = min(frame.light_count, uint(sceneLights.items.length()));
    vec3 sum = vec3(0.0);
    for (uint word = 0u; 32u * word < count; ++word) {
        for (uint rest = lamps.items[word]; rest != 0u; rest &= rest - 1u) {
            const uint i = 32u * word + uint(findLSB(rest));
            sum += uintBitsToFloat(lamps.items[kLampWords + i]) * lamp_irradiance(sceneLights.items[i], t);
        }
    }
    return sum;
}

// Returns true if a surface at this position belongs to a lamp that the probe sees.
bool is_on_seen_lamp(vec3 position) {
    const uint count = min(frame.light_count, uint(sceneLights.items.length()));
    for (uint word = 0u; 32u * word < count; ++word)
        for (uint rest = lamps.items[word]; rest != 0u; rest &= rest - 1u)
            if (is_on_lamp(sceneLights.items[32u * word + uint(findLSB(rest))], position)) return true;
    return false;
}

// Returns irradiance / π of the light that other surfaces have reflected in earlier rounds.
vec3 bounced_over_pi(Texel t) {
    if (probeFeedback == 0) return vec3(0.0);
    const float basis[9] = harmonic_basis(t.normal);
    vec3 sum = vec3(0.0);
    if (probeFeedback == 2) {
        for (uint i = 0u; i < 9u; ++i) sum += probeSh.items[uint(params.p) * kProbeShStride + i].rgb * basis[i];
        return max(sum, vec3(0.0));
    }
    // Places outside of the volume have the light of the surroundings. In the first rounds, some probes have no light
    // yet. They count as dark, so that no light from elsewhere gets into closed rooms.
    const ProbeLight volume = probe_light(t.position, t.normal, t.to_probe, t.normal, t.normal, vec3(0.0));
    const vec3 known = volume.facing * volume.validity;
    if (volume.outside <= 0.0) return known;
    const int terms = min(environmentSh.items.length(), 9);
    for (int i = 0; i < terms; ++i) sum += environmentSh.items[i].rgb * basis[i];
    return known + max(sum, vec3(0.0)) * volume.outside;
}

// The light that reaches the texels of a block: irradiance / π of the sun and of lamps, and of other surfaces.
struct IncidentOverPi {
    vec3 direct, bounced;
};

// Returns the place of texel `i` of a block. Different blocks begin with different texels, so that the mean place of
// the first texels of many blocks is the middle of the blocks.
ivec3 texel_of_block(ivec3 block, int i) {
    const int at = (i + block.x + 3 * block.y) % (blockSide * blockSide);
    return ivec3(block.xy * blockSide + ivec2(at % blockSide, at / blockSide), block.z);
}

// Returns the light that reaches one texel of the block: the first texel that shows the front of a surface.
IncidentOverPi incident_on(ivec3 block, vec3 probe) {
    ivec3 first;
    float distance_m = 0.0;
    for (int i = 0; i < blockSide * blockSide && distance_m <= 0.0; ++i) {
        first = texel_of_block(block, i);
        distance_m = texelFetch(probeDistance, first, 0).r;
    }
    if (distance_m <= 0.0) return IncidentOverPi(vec3(0.0), vec3(0.0));
    const Texel t = texel_at(first, probe, distance_m);
    return IncidentOverPi((sun_irradiance(t) + lamps_irradiance(t)) / kPi, bounced_over_pi(t));
}

// Returns the radiance of a texel. The back of a surface is dark.
vec3 radiance_of(ivec3 at, vec3 probe, IncidentOverPi light) {
    const float distance_m = texelFetch(probeDistance, at, 0).r;
    if (distance_m < 0.0) return vec3(0.0);
    if (distance_m == 0.0) return texelFetch(probeSky, at, 0).rgb * frame.environment_unit;
    const vec3 root = texelFetch(probeAlbedo, at, 0).rgb, albedo = root * root;
    vec3 emission = texelFetch(probeEmission, at, 0).rgb / kProbeRadianceScale;
    if (emission != vec3(0.0) && is_on_seen_lamp(texel_at(at, probe, distance_m).position)) emission = vec3(0.0);
    return emission + albedo * light.direct + min(albedo, vec3(kMostAlbedo)) * light.bounced;
}

void main() {
    const ivec3 block = ivec3(gl_GlobalInvocationID);
    if (any(greaterThanEqual(block.xy * blockSide, imageSize(lit).xy))) return;
    const vec3 probe = probePoints.items[params.p].position;
    const IncidentOverPi light = incident_on(block, probe);
    for (int i = 0; i < blockSide * blockSide; ++i) {
        const ivec3 at = texel_of_block(block, i);
        imageStore(lit, at, vec4(radiance_of(at, probe, light), 1.0));
    }
}
