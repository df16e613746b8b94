// Descriptor set 0: constants of the frame and of the view. Every shader that uses them includes this file.
#ifndef WEFT_FRAME_SET
#define WEFT_FRAME_SET
#include "shared/frame.glsl"
#include "shared/further_suns.glsl"
#include "shared/light_function.glsl"
#include "shared/sun.glsl"

layout(set = 0, binding = 0, std140) uniform FrameBlock { FrameConstants frame; };
layout(set = 0, binding = 1, std140) uniform ViewBlock { ViewConstants view; };
layout(set = 0, binding = 2) uniform sampler2D environment;  // Equirectangular picture of the sky; see sky.glsl.
layout(set = 0, binding = 3, std140) uniform SunBlock { SunConstants sun; };
layout(set = 0, binding = 4, std430) readonly buffer LightFunctions { LightFunction items[]; } light_functions;
// Pictures that lights project; see light_function.glsl.
layout(set = 0, binding = 5) uniform sampler2DArray light_pictures;
layout(set = 0, binding = 6) uniform sampler2D environment_light;  // Small picture of the sky, for lighting.
layout(set = 0, binding = 7, std140) uniform FurtherSunBlock { FurtherSuns further_suns; };

// Returns the world position for `uv`, which is (0,0) at the top left, and a reversed `depth`, which must not be 0.
vec3 world_position(vec2 uv, float depth) {
    const vec4 world = view.inverse_view_projection * vec4(uv * 2.0 - 1.0, depth, 1.0);
    return world.xyz / world.w;
}

// Returns the direction of the camera ray through the position `uv` of the picture.
vec3 ray_direction(vec2 uv) { return normalize(world_position(uv, 1.0) - view.eye); }
#endif
