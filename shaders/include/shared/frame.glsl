// Contents of bindings 0 and 1 of descriptor set 0: constants of the frame, and the view of a pass. Units: metres,
// cd/m². Clip space is Vulkan's; `projection` contains the flip of y. Depth is reversed: 1 at the distance `near_m`,
// 0 at infinity.
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
    float pre_exposure;       // Pre-exposure: factor for radiance before it is stored in hdr.
    float prev_pre_exposure;
    float delta_time_s;
    float environment_scale;  // Factor for texels of the environment picture; 0 if the scene has no picture.
    uint directional_count;   // Number of directional lights, which are the first lights in the list.
    uint plain_count;         // Number of lights before the first with an area or a light function.
    float environment_unit;   // Factor for texels of the filtered environment cube, a power of two.
    float environment_light_scale;  // Factor for texels of the small picture for lighting.
    // rgb: coefficients of the functions 1, x, y, z, xy, yz, xz, 3y² − 1 and x² − z² of the normal (x, y, z).
    vec4 environment_irradiance_over_pi[9];
    uint unshadowed_count;    // Number of these plain lights before the first with shadow maps of a lamp.
    uint reserved1, reserved2, reserved3;
};

// A buffer of the graph may contain views. Then a uniform block begins at each element, so the size of the struct is a
// multiple of 256 bytes, which every device allows as the offset of a uniform block.
struct ViewConstants {
    mat4 view;               // Matrix from world space to view space.
    mat4 projection;         // Matrix from view space to clip space.
    mat4 view_projection;
    mat4 inverse_view_projection;
    mat4 steady_view_projection;  // World to clip space without jitter, because velocities must not contain it.
    mat4 prev_view_projection;    // World to clip space of the previous frame, without jitter.
    vec3 eye;
    float near_m;
    vec2 viewport_px;
    vec2 inverse_viewport;
    vec2 jitter_uv;               // Offset of the picture by the jitter in `projection`; 0 if no "jitter" is set.
    uint number;                  // Number of the view in its list: 2 for "sun(2)". 0 for the camera.
    float mip_bias;               // Added to the mip of textures: below 0 if frames with jitter are averaged.
    vec4 reserved1[5];
};

#include "end.glsl"
#endif
