// Computes one step of the Gray–Scott model of two chemicals. u is food, and v consumes it: one u and two v become
// three v. Both diffuse, and v decays.
//   u' = Δu·Du − u·v² + feed·(1 − u)      v' = Δv·Dv + u·v² − (feed + kill)·v
// Source: Pearson 1993, "Complex Patterns in a Simple System". Du = 1, Dv = ½ and the nine-point Laplacian (sides 0.2,
// corners 0.05) are from Karl Sims, "Reaction-Diffusion Tutorial", for time steps of 1. Feed and kill vary across the
// dish, so that several patterns appear.
#version 460

layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D before;
layout(rg32f) writeonly uniform image2D after;

layout(push_constant) uniform Params {
    uint frameIndex;
    int i;       // Number of the step in this frame, counted from 1.
    uint seed;
    float feed;
    float kill;
    float drift;  // Changes `feed` by −drift in the middle of the dish, by +drift at its left and right edges.
} params;

uint mixed_bits(uint x) {
    x = (x ^ (x >> 16)) * 0x7feb352du;
    x = (x ^ (x >> 15)) * 0x846ca68bu;
    return x ^ (x >> 16);
}

float random(ivec2 cell, uint salt) {
    const uint bits = mixed_bits(uint(cell.x) ^ mixed_bits(uint(cell.y) ^ mixed_bits(params.seed * 8u + salt)));
    return float(bits >> 8) / 16777216.0;
}

// Returns the first state (u, v) of a cell: (1, 0) outside the drops of v. About two of five squares of a grid contain
// a drop.
vec2 first_cell(ivec2 cell) {
    const int kGrid = 30;
    const ivec2 square = cell / kGrid;
    const vec2 middle = (vec2(square) + 0.25 + 0.5 * vec2(random(square, 0u), random(square, 1u))) * float(kGrid);
    const float radius = 2.0 + 4.0 * random(square, 2u);
    const bool in_drop = random(square, 3u) < 0.4 && distance(vec2(cell), middle) < radius;
    return in_drop ? vec2(0.5, 0.25 + 0.1 * random(cell, 4u)) : vec2(1.0, 0.0);
}

// Returns the kill rate at which pure food becomes the only steady state. Patterns exist near this rate. Far from it, v
// fills the dish or vanishes.
float border(float feed) { return 0.5 * sqrt(feed) - feed; }

vec2 changed(ivec2 cell, vec2 here, vec2 sides, vec2 corners) {
    const vec2 spread = 0.2 * sides + 0.05 * corners - here;
    const vec2 place = abs(2.0 * (vec2(cell) + 0.5) / vec2(imageSize(after)) - 1.0);
    const float feed = params.feed + params.drift * (2.0 * place.x - 1.0);
    const float kill = params.kill + border(feed) - border(params.feed) + 0.05 * params.drift * (1.0 - 2.0 * place.y);
    const float eaten = here.x * here.y * here.y;
    return here + vec2(spread.x - eaten + feed * (1.0 - here.x), 0.5 * spread.y + eaten - (feed + kill) * here.y);
}

// Returns the coordinates of a cell, wrapped around at the edges of the dish.
ivec2 around(ivec2 cell, ivec2 size) {
    return cell + size * (ivec2(lessThan(cell, ivec2(0))) - ivec2(greaterThanEqual(cell, size)));
}

// Computes 2×2 cells per invocation. Together, their neighbourhoods have only 16 different cells, so 16 reads are
// enough; four separate neighbourhoods of 9 cells would need 36.
void main() {
    const ivec2 first = ivec2(gl_GlobalInvocationID.xy) * 2, size = imageSize(after);
    if (any(greaterThanEqual(first, size))) return;
    // A loop replaces an `if`: some devices execute the body of every `if`, even if no cell needs it, but they skip a
    // loop that no cell enters.
    const bool begins = params.frameIndex == 0u && params.i == 1;
    for (int k = begins ? 0 : 4; k < 4; ++k) {
        const ivec2 cell = first + ivec2(k & 1, k >> 1);
        imageStore(after, cell, vec4(first_cell(cell), 0.0, 0.0));
    }
    if (begins) return;
    vec2 near[16];
    for (int k = 0; k < 16; ++k) near[k] = texelFetch(before, around(first + ivec2(k & 3, k >> 2) - 1, size), 0).rg;
    for (int k = 0; k < 4; ++k) {
        const int m = 5 + (k & 1) + (k >> 1) * 4;
        const vec2 sides = near[m - 1] + near[m + 1] + near[m - 4] + near[m + 4];
        const vec2 corners = near[m - 5] + near[m - 3] + near[m + 3] + near[m + 5];
        const ivec2 cell = first + ivec2(k & 1, k >> 1);
        imageStore(after, cell, vec4(changed(cell, near[m], sides, corners), 0.0, 0.0));
    }
}
