// The depth slices of a tile that contain a pixel, with the rows and columns of these pixels. Requires
// pixel_box.glsl, reach.glsl, sorted_list.glsl, super_list.glsl and the images `depth`, `hiz` and
// `glassDepth`. For workgroups of 32 threads, one workgroup per tile; each thread processes 4 × 2 pixels.

const int kSlices = 32;

shared uint slice_pixels[kSlices];  // bit masks: columns in the lower half, rows in the upper half; 0: no pixel
shared uint slice_edges[kSlices];   // first column, first row, last column, last row of these pixels; one byte each
shared uint occupied;               // one bit for each slice that contains a pixel
shared uint nearest_z, farthest_z;  // bit patterns of floats, which sort in the same order as non-negative floats

float first_m, slice_m, last_m;     // start of the first slice, thickness of a slice, end of the last slice

struct TileBounds {
    vec3 axis;     // direction through the tile's middle, one metre long along the view
    float spread;  // largest distance of the tile's pixels from that axis, at one metre
    uint occupied;
};

// The order in which textureGather returns the pixels of a square.
const ivec2 kGathered[4] = ivec2[](ivec2(0, 1), ivec2(1, 1), ivec2(1, 0), ivec2(0, 0));

ivec2 tile_origin() { return ivec2(gl_WorkGroupID.xy) * kTilePx; }

// Each thread processes two squares of 2 × 2 pixels, side by side.
ivec2 squares_in_tile() { return ivec2(gl_LocalInvocationIndex & 3u, gl_LocalInvocationIndex >> 2) * ivec2(4, 2); }

// Returns 0 outside the picture.
vec4 gather_depth(sampler2D image, ivec2 square) {
    const vec4 z = textureGather(image, vec2(square + 1) * view.inverse_viewport);
    const bvec2 inside = lessThan(square + 1, ivec2(view.viewport_px));
    const bvec4 seen = bvec4(inside.y, inside.x && inside.y, inside.x, true);
    return any(greaterThanEqual(square, ivec2(view.viewport_px))) ? vec4(0.0) : mix(vec4(0.0), z, seen);
}

int slice_of(float distance_m) { return int(clamp((distance_m - first_m) / slice_m, 0.0, float(kSlices - 1))); }

uint pixel_bits(ivec2 in_tile) { return (1u << in_tile.x) | (1u << (16 + in_tile.y)); }

// The slice of each pixel of a square; -1 for pixels without a surface.
ivec4 slices_of(ivec2 square) {
    const vec4 z = gather_depth(depth, tile_origin() + square);
    return ivec4(z.x > 0.0 ? slice_of(distance_of(z.x)) : -1, z.y > 0.0 ? slice_of(distance_of(z.y)) : -1,
                 z.z > 0.0 ? slice_of(distance_of(z.z)) : -1, z.w > 0.0 ? slice_of(distance_of(z.w)) : -1);
}

int most(ivec4 v) { return max(max(v.x, v.y), max(v.z, v.w)); }

uint pixels_in(ivec4 slices, int k, ivec2 square) {
    uint pixels = 0u;
    for (int i = 0; i < 4; ++i)
        if (slices[i] == k) pixels |= pixel_bits(square + kGathered[i]);
    return pixels;
}

ivec4 below(ivec4 slices, int k) { return mix(ivec4(-1), slices, lessThan(slices, ivec4(k))); }

// Pixels in the same slice are added together. Returns the slices as bits.
uint enter_opaque(ivec2 square) {
    const ivec2 beside = square + ivec2(2, 0);
    const ivec4 a = slices_of(square), b = slices_of(beside);
    uint entered = 0u;
    int k = max(most(a), most(b));
    for (;;) {
        if (k >= 0) {
            atomicOr(slice_pixels[k], pixels_in(a, k, square) | pixels_in(b, k, beside));
            entered |= 1u << k;
        }
        k = max(most(below(a, k)), most(below(b, k)));
        if (k < 0) return entered;
    }
}

// Adds all slices from the transparent surface to the opaque one, or to the last slice. Returns them as bits.
uint enter_translucent_square(ivec2 square) {
    const vec4 z = gather_depth(depth, tile_origin() + square), glass = gather_depth(glassDepth, tile_origin() + square);
    uint entered = 0u;
    for (int i = 0; i < 4; ++i) {
        if (glass[i] <= 0.0) continue;
        const int last = z[i] > 0.0 ? slice_of(distance_of(min(z[i], glass[i]))) : kSlices - 1;
        for (int k = slice_of(distance_of(glass[i])); k <= last; ++k) {
            atomicOr(slice_pixels[k], pixel_bits(square + kGathered[i]));
            entered |= 1u << k;
        }
    }
    return entered;
}

uint enter_translucent(ivec2 square) {
    return enter_translucent_square(square) | enter_translucent_square(square + ivec2(2, 0));
}

// From the nearest transparent surface to the farthest surface, ignoring the sky.
vec2 translucent_range() {
    for (int s = 0; s < 2; ++s) {
        const ivec2 square = tile_origin() + squares_in_tile() + ivec2(2 * s, 0);
        const vec4 z = gather_depth(depth, square), glass = gather_depth(glassDepth, square);
        for (int i = 0; i < 4; ++i) {
            if (glass[i] <= 0.0) continue;
            atomicMax(nearest_z, floatBitsToUint(glass[i]));
            atomicMin(farthest_z, floatBitsToUint(z[i] > 0.0 ? min(z[i], glass[i]) : glass[i]));
        }
    }
    barrier();
    return vec2(uintBitsToFloat(nearest_z), uintBitsToFloat(farthest_z));
}

// Returns false, in all threads, if the tile shows no lit surface. Ends with a barrier.
bool find_slices() {
    slice_pixels[gl_LocalInvocationIndex] = 0u;
    if (gl_LocalInvocationIndex == 0u) {
        occupied = nearest_z = 0u;
        farthest_z = floatBitsToUint(1.0);
    }
    begin_rounds();
    barrier();
    const vec2 range = TRANSLUCENT ? translucent_range() : texelFetch(hiz, ivec2(gl_WorkGroupID.xy), 0).rg;
    first_m = distance_of(range.x);
    // A slice must be thicker than the precision of single-precision distances.
    slice_m = max((distance_of(range.y) - first_m) / float(kSlices), kPlaceError * distance_of(range.y));
    last_m = TRANSLUCENT ? kEndless : first_m + slice_m * float(kSlices);
    const uint entered = TRANSLUCENT ? enter_translucent(squares_in_tile()) : enter_opaque(squares_in_tile());
    if (entered != 0u) atomicOr(occupied, entered);
    barrier();
    return range.x > 0.0;
}

// Call this after find_slices().
TileBounds tile_bounds() {
    const ivec2 last = min(tile_origin() + kTilePx, ivec2(view.viewport_px)) - 1;
    const Slopes slopes = slopes_of(tile_origin(), last);
    const vec2 half_size = (slopes.high - slopes.low) * 0.5;
    return TileBounds(vec3(slopes.low + half_size, -1.0), length(half_size), occupied);
}

// The slices between two distances, as bits. Positions slightly beyond an edge still count, because of
// rounding.
uint slices_between(float near_m, float far_m) {
    const float a = (near_m - first_m) / slice_m - 0.01, b = (far_m - first_m) / slice_m + 0.01;
    if (b < max(a, 0.0) || (!TRANSLUCENT && a > float(kSlices))) return 0u;
    return (~0u << int(clamp(a, 0.0, kSlices - 1.0))) & (~0u >> (kSlices - 1 - int(clamp(b, 0.0, kSlices - 1.0))));
}

// The occupied slices that a light inside this sphere and between two distances may reach: those where the
// tile's axis lies inside the sphere, enlarged by the tile's radius. This is a tighter test than the sphere's
// whole depth range, because a tile near the sphere's rim intersects only a short part of it.
uint slices_at(vec4 sphere, float near_m, float far_m, TileBounds b) {
    const float at_m = dot(b.axis, sphere.xyz) / dot(b.axis, b.axis);
    const vec3 aside = sphere.xyz - at_m * b.axis, sizes = abs(sphere.xyz);
    const float error_m = kPlaceError * (2.0 * (sizes.x + sizes.y + sizes.z) + sphere.w);
    const float radius_m = sphere.w + b.spread * clamp(sphere.w - sphere.z, 0.0, last_m) + error_m;
    const float rest = radius_m * radius_m - dot(aside, aside);
    const float half_m = sqrt(max(rest, 0.0) / dot(b.axis, b.axis));
    return rest < 0.0 ? 0u : slices_between(max(near_m, at_m - half_m), min(far_m, at_m + half_m)) & b.occupied;
}

// Call this after find_slices(); the caller must add a barrier afterwards.
void find_edges() {
    const uint pixels = slice_pixels[gl_LocalInvocationIndex], columns = pixels & 0xFFFFu, rows = pixels >> 16;
    slice_edges[gl_LocalInvocationIndex] =
        uint(findLSB(columns)) | uint(findLSB(rows)) << 8 | uint(findMSB(columns)) << 16 | uint(findMSB(rows)) << 24;
}

Box slice_box(int k) {
    const uint edges = slice_edges[k];
    const Slopes slopes = slopes_of(tile_origin() + ivec2(edges & 0xFFu, edges >> 8 & 0xFFu),
                                    tile_origin() + ivec2(edges >> 16 & 0xFFu, edges >> 24));
    const float near_m = first_m + slice_m * float(k);
    return box_of(slopes, near_m, k == kSlices - 1 ? last_m : near_m + slice_m);
}

// True if a light inside this sphere reaches one of these slices.
bool reaches_slice(vec4 sphere, Reach r, uint slices) {
    for (;;) {
        const int k = max(findLSB(slices), 0);
        const Box box = slice_box(k);
        if (slices != 0u && sphere_meets(sphere, box) && reaches(r, box)) return true;
        slices &= slices - 1u;
        if (slices == 0u) return false;
    }
}
