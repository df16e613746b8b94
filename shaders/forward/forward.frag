// Draws a surface and lights it in the same pass. Opaque and masked surfaces hide the surfaces behind them. Transparent
// surfaces are blended with premultiplied alpha. A transmissive surface lets the light behind it pass where it does not
// mirror light; before, the passes of graphs/modules/refraction.json have bent and tinted this light. Output: scene-linear
// Rec.709, cd/m² × preExposure.
#version 460
#define WEFT_WITHOUT_NEAR_FIELD  // It is known only for the surfaces of the G-buffer.
#include "brdf.glsl"
#include "frame_set.glsl"
#include "half_float.glsl"
#include "lights.glsl"
#include "material_set.glsl"
#include "octahedral.glsl"
#include "ripples.glsl"
#include "sky.glsl"
#include "surface_fragment.glsl"

layout(constant_id = 0) const bool MASKED = false;
layout(constant_id = 1) const bool BLENDED = false;
// If true, rounds the surface properties to the precision of the G-buffer and computes the position from depth. Then
// pictures of forward and deferred shading can be compared.
layout(constant_id = 2) const bool QUANTIZED = false;
// True if the pass draws the list "anisotropic". Other lists of opaque surfaces draw anisotropic ones as isotropic ones.
layout(constant_id = 3) const bool ANISOTROPIC = false;

layout(location = 5) in vec3 world_point;

layout(location = 0) out vec4 hdr;

#include "surface_light.glsl"

const float kMaxStored = 65000.0;
const float kCoatF0 = 0.04;  // Of an index of refraction of 1.5.

const int kBack = 0, kFront = 1, kCoat = 2;

// Returns the colour of the scattered light that comes through a surface. All light that leaves the surface is at most the
// light that it receives; see base_under_coat(). `clear`: share of the light that passes without being scattered.
vec3 color_of_back(Surface front, vec3 v, float metalness, float clear) {
    const vec3 left = max(1.0 - mirrored_share(with_albedo(front, v)) - front.diffuse, vec3(0.0));
    return min(material.transmitted_color * ((1.0 - metalness) * (1.0 - clear)), left);
}

// Returns the luminance of a surface with emission and up to three layers. The back lets a part of its light pass to the
// front, scattered by the body in between (KHR_materials_diffuse_transmission). A clear coat mirrors a part of the light,
// and dims the surface below by the same part (KHR_materials_clearcoat). The loop has one call for all layers, because the
// shader is large.
vec3 layered_luminance(Surface base, vec3 point, vec3 orm, float coat_roughness, float clear) {
    const ivec2 pixel = ivec2(gl_FragCoord.xy);
    const vec3 v = normalize(view.eye - point);
    const bool has_back = material.diffuse_share < 1.0;
    vec3 light = emission();
    for (int i = has_back ? kBack : kFront; i <= (base.under_coat ? kCoat : kFront); ++i) {
        Surface layer = base;
        vec3 eye = v, place = point;
        float share = 1.0;
        if (i == kBack) {
            layer = make_surface(-base.normal, color_of_back(base, v, orm.b, clear), 0.0, 1.0, vec3(0.0), 0.0);
            layer.under_coat = true;  // Reflections of the screen are those of the front.
            eye = reflect(v, base.normal);  // As if the eye were behind the surface.
            place = point - mesh_normal() * material.thickness_m;
        }
        if (i == kCoat) {
            share = material.clearcoat;
            layer = make_surface(mesh_normal(), vec3(0.0), 0.0, coat_roughness, vec3(kCoatF0), 1.0);
            light *= 1.0 - share * mirrored_share(with_albedo(layer, v));
            orm.g = coat_roughness;
        }
        light += share * reflected_radiance(layer, eye, place, vec3(orm.r, i == kBack ? 1.0 : orm.g, orm.b), pixel);
    }
    return light;
}

vec4 unorm8(vec4 x) { return unpackUnorm4x8(packUnorm4x8(x)); }
vec2 snorm16(vec2 x) { return unpackSnorm2x16(packSnorm2x16(x)); }

void main() {
    const vec4 base = base_color();
    vec3 n = BLENDED ? rippled_normal() : shading_normal();
    const vec3 dx = dFdx(n), dy = dFdy(n);  // Derivatives are undefined after a discard.
    const vec3 face = mesh_normal();
    const float coat_roughness = roughness_of_pixel(material.clearcoat_roughness, dFdx(face), dFdy(face));
    if (MASKED && base.a < material.alpha_cutoff) discard;
    vec3 orm = occlusion_roughness_metalness();
    orm.g = roughness_of_pixel(orm.g, dx, dy);
    vec3 root = sqrt(reflected_color(base.rgb, orm.b));
    vec3 point = world_point;
    vec4 coat = vec4(sqrt(material.dielectric_f0), material.specular);
    if (QUANTIZED) {
        n = octahedral_decode(snorm16(octahedral_encode(n)));
        orm = unorm8(vec4(orm, 1.0)).rgb;
        root = unorm8(vec4(root, 1.0)).rgb;
        coat = unorm8(coat);
        point = world_position(gl_FragCoord.xy / view.viewport_px, gl_FragCoord.z);
    }
    const float transmission = BLENDED ? material.transmission * (1.0 - orm.b) : 0.0;
    Surface s = make_surface(n, root * root, orm.b, orm.g, coat.rgb * coat.rgb, coat.a);
    s.oren_nayar = material.oren_nayar;
    if (ANISOTROPIC || (BLENDED && material.anisotropy > 0.0)) {
        const vec4 grain = anisotropy(n);
        s = stretched(s, grain.xyz, grain.w);
    }
    s.diffuse *= 1.0 - transmission;
    s.under_coat = !BLENDED && material.clearcoat > 0.0;
    const vec3 radiance = layered_luminance(s, point, orm, coat_roughness, transmission) * frame.pre_exposure;
    const float coverage = BLENDED ? base.a : 1.0;
    float alpha = coverage;
    if (transmission > 0.0) {
        const vec3 mirrored = mirrored_share(with_albedo(s, normalize(view.eye - point)));
        alpha *= 1.0 - transmission * (1.0 - dot(mirrored, vec3(1.0 / 3.0)));
    }
    hdr = vec4(nearest_half(min(radiance * coverage, vec3(kMaxStored))), alpha);
}
