// The circle of confusion of a thin lens whose focal length is much shorter than all distances. Requires
// frame_set.glsl.

const float kMostRadius = 12.0;

// The circle's radius in pixels of half resolution: positive behind the focus, negative in front of it.
// `depth` is reversed.
float circle_radius(float depth, float focus_m, float aperture_m) {
    const float pixels_per_rad = 0.5 * view.viewport_px.y * abs(view.projection[1][1]);
    const float diameter_rad = aperture_m * (1.0 / focus_m - depth / view.near_m);
    return clamp(0.25 * pixels_per_rad * diameter_rad, -kMostRadius, kMostRadius);
}

// The blurred share of a pixel: 0 for radii below a quarter of a pixel, 1 above 0.85.
float blurred_share(float radius) { return smoothstep(0.25, 0.85, radius); }
