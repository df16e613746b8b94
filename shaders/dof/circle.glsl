// Computes the circle of confusion of a thin lens whose focal length is much shorter than all distances. Requires
// frame_set.glsl.

const float kMostRadius = 12.0;

// Returns the radius of the circle in pixels of the half-size picture. The radius is positive behind the focus and
// negative in front of it. `depth` is reversed (near plane / distance).
float circle_radius(float depth, float focus_m, float aperture_m) {
    const float pixels_per_rad = 0.5 * view.viewport_px.y * abs(view.projection[1][1]);
    const float diameter_rad = aperture_m * (1.0 / focus_m - depth / view.near_m);
    return clamp(0.25 * pixels_per_rad * diameter_rad, -kMostRadius, kMostRadius);
}

// Returns the share of the blurred layers in the colour of a pixel. `radius`: in pixels of the half-size picture. The
// share is 0 for radii below 0.25 and 1 for radii above 0.85.
float blurred_share(float radius) { return smoothstep(0.25, 0.85, radius); }
