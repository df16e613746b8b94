// Computes the light of one light source on the surface at a pixel; blending adds it to hdr. Back faces of the volume
// are discarded, because they only write stencil. Output: scene-linear Rec.709, cd/m² × preExposure.
#version 460
#include "brdf.glsl"
#include "dfg.glsl"
#include "frame_set.glsl"
#include "lights.glsl"
#include "octahedral.glsl"
#include "gbuffer_surface.glsl"
#include "lamp_reflection.glsl"

layout(early_fragment_tests) in;

layout(location = 0) flat in uint light_index;
layout(location = 0) out vec4 hdr;

uniform sampler2D surfaceDepth;
layout(std430) readonly buffer Lights { Light items[]; } lights;

const float kMaxStored = 65000.0;

void main() {
    if (!gl_FrontFacing) discard;
    const ivec2 pixel = ivec2(gl_FragCoord.xy);
    const vec3 position = world_position(gl_FragCoord.xy * view.inverse_viewport, texelFetch(surfaceDepth, pixel, 0).r);
    const vec3 v = normalize(view.eye - position);
    const Surface s = with_albedo(gbuffer_surface(pixel, texelFetch(orm, pixel, 0).rgb), v);
    const vec3 radiance = lamp_reflection(s, v, position, lights.items[light_index]) * frame.pre_exposure;
    hdr = vec4(min(radiance, vec3(kMaxStored)), 0.0);
}
