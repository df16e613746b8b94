// Set 0: the frame and the view. Every shader that uses one of them includes this file.
#ifndef WEFT_FRAME_SET
#define WEFT_FRAME_SET
#include "shared/frame.glsl"
#include "shared/light_function.glsl"
#include "shared/sun.glsl"

layout(set = 0, binding = 0, std140) uniform FrameBlock { FrameConstants frame; };
layout(set = 0, binding = 1, std140) uniform ViewBlock { ViewConstants view; };
layout(set = 0, binding = 2) uniform sampler2D environment;  // equirectangular; see sky.glsl
layout(set = 0, binding = 3, std140) uniform SunBlock { SunConstants sun; };
layout(set = 0, binding = 4, std430) readonly buffer LightFunctions { LightFunction items[]; } light_functions;
layout(set = 0, binding = 5) uniform sampler2DArray light_pictures;  // see light_function.glsl

// World position of the point at `uv` (0,0 top left) and reversed-Z `depth` > 0.
vec3 world_position(vec2 uv, float depth) {
    const vec4 world = view.inverse_view_projection * vec4(uv * 2.0 - 1.0, depth, 1.0);
    return world.xyz / world.w;
}

// Direction of the camera ray through `uv`, towards the point on the near plane.
vec3 ray_direction(vec2 uv) { return normalize(world_position(uv, 1.0) - view.eye); }
#endif
