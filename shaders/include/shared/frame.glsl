// The contents of set 0: constants of the frame, and the view of a pass. Units: metres, cd/m². Clip space is
// Vulkan's, with the y flip in `projection`; depth is reversed, 1 at `near_m`.
#ifndef WEFT_SHARED_FRAME
#define WEFT_SHARED_FRAME
#include "begin.glsl"

struct FrameConstants {
    vec3 sky_zenith;
    uint light_count;
    vec3 sky_horizon;
    uint frame_index;
    vec3 sky_ground;
    float time_s;
    float pre_exposure;       // factor for values before they are stored in hdr
    float prev_pre_exposure;
    float delta_time_s;
    float environment_scale;  // factor for the environment's texels; 0: the scene has the gradient sky instead
    uint directional_count;   // number of directional lights, which come first
    uint plain_count;         // number of lights before those with an area or a light function
    uint reserved0;
    uint reserved1;
    vec4 environment_irradiance_over_pi[9];  // rgb; times 1, x, y, z, xy, yz, xz, 3y² − 1, x² − z²
};

struct ViewConstants {
    mat4 view;               // world to view
    mat4 projection;         // view to clip
    mat4 view_projection;
    mat4 inverse_view_projection;
    mat4 steady_view_projection;  // without the jitter, which velocities must not contain
    mat4 prev_view_projection;    // of the previous frame, without its jitter
    vec3 eye;
    float near_m;
    vec2 viewport_px;
    vec2 inverse_viewport;
    vec2 jitter_uv;               // offset of the picture in `projection`; 0 unless the graph has "jitter"
    vec2 reserved0;
};

#include "end.glsl"
#endif
