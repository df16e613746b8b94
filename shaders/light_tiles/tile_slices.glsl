// Finds the depth slices of a tile that contain a pixel, and the rows and columns of these pixels. There is one
// workgroup of 32 threads per tile; each thread processes 4 × 2 pixels. Requires pixel_box.glsl, reach.glsl,
// sorted_list.glsl, super_list.glsl and the images `depth`, `hiz` and `glassDepth`.

const int kSlices = 32;

shared uint slice_pixels[kSlices];  // Pixels of each slice: bits of columns (low 16), of rows (high 16).
// Edges of the pixels of each slice: first column, first row, last column, last row, 8 bits each.
shared uint slice_edges[kSlices];
shared uint occupied;               // One bit for each slice that contains a pixel.
shared uint nearest_z, farthest_z;  // Bits of depth values; non-negative floats sort like their bits.

float first_m, slice_m, last_m;     // In metres: start of the first slice, thickness of a slice, end of the last slice.

struct TileBounds {
    vec3 axis;     // Direction through the middle of the tile; its part along the view axis has length 1.
    float spread;  // Largest distance of the tile's pixels from this axis, at 1 m along the view axis.
    uint occupied;
};

// Offsets of the four pixels of a square, in the order in which textureGather returns them.
const ivec2 kGathered[4] = ivec2[](ivec2(0, 1), ivec2(1, 1), ivec2(1, 0), ivec2(0, 0));

ivec2 tile_origin() { return ivec2(gl_WorkGroupID.xy) * kTilePx; }

// Returns the first pixel of the thread: each thread processes two squares of 2 × 2 pixels, side by side.
ivec2 squares_in_tile() { return ivec2(gl_LocalInvocationIndex & 3u, gl_LocalInvocationIndex >> 2) * ivec2(4, 2); }

// Returns the depths of a square of 2 × 2 pixels. Pixels outside the picture get the depth 0.
vec4 gather_depth(sampler2D image, ivec2 square) {
    const vec4 z = textureGather(image, vec2(square + 1) * view.inverse_viewport);
    const bvec2 inside = lessThan(square + 1, ivec2(view.viewport_px));
    const bvec4 seen = bvec4(inside.y, inside.x && inside.y, inside.x, true);
    return any(greaterThanEqual(square, ivec2(view.viewport_px))) ? vec4(0.0) : mix(vec4(0.0), z, seen);
}

int slice_of(float distance_m) { return int(clamp((distance_m - first_m) / slice_m, 0.0, float(kSlices - 1))); }

uint pixel_bits(ivec2 in_tile) { return (1u << in_tile.x) | (1u << (16 + in_tile.y)); }

// Returns the slice of each pixel in a square of 2 × 2 pixels; −1 for pixels without a surface.
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

// Adds the pixels of two squares to slices, with one atomic operation per slice. Returns the slices as bits.
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

// Adds each pixel with glass to all slices from the glass to the opaque surface, or to the last slice if there is no
// opaque surface. Returns the slices as bits.
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

// Returns the depth range of the pixels with glass. The nearest depth is that of the nearest glass. The farthest depth
// is that of an opaque surface behind glass, or of the glass itself if there is only sky behind the glass.
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

// Sorts the tile's pixels into slices. All threads return false if the tile has no surface (TRANSLUCENT: no glass).
// Ends with a barrier.
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
    // A slice must be thicker than the rounding error of distances in single precision.
    slice_m = max((distance_of(range.y) - first_m) / float(kSlices), kPlaceError * distance_of(range.y));
    last_m = TRANSLUCENT ? kEndless : first_m + slice_m * float(kSlices);
    const uint entered = TRANSLUCENT ? enter_translucent(squares_in_tile()) : enter_opaque(squares_in_tile());
    if (entered != 0u) atomicOr(occupied, entered);
    barrier();
    return range.x > 0.0;
}

// Returns the axis, spread and occupied slices of the tile. The caller must call find_slices() before.
TileBounds tile_bounds() {
    const ivec2 last = min(tile_origin() + kTilePx, ivec2(view.viewport_px)) - 1;
    const Slopes slopes = slopes_of(tile_origin(), last);
    const vec2 half_size = (slopes.high - slopes.low) * 0.5;
    return TileBounds(vec3(slopes.low + half_size, -1.0), length(half_size), occupied);
}

// Returns the slices between two distances, as bits. A slice also counts if a distance is slightly outside its edge,
// because of rounding.
uint slices_between(float near_m, float far_m) {
    const float a = (near_m - first_m) / slice_m - 0.01, b = (far_m - first_m) / slice_m + 0.01;
    if (b < max(a, 0.0) || (!TRANSLUCENT && a > float(kSlices))) return 0u;
    return (~0u << int(clamp(a, 0.0, kSlices - 1.0))) & (~0u >> (kSlices - 1 - int(clamp(b, 0.0, kSlices - 1.0))));
}

// Returns the occupied slices that a light inside this sphere and between two distances may reach. These are the slices
// where the axis of the tile is inside the sphere, enlarged by the radius of the tile. The whole depth range of the
// sphere would be larger: a tile near the rim of the sphere meets only a short part of this range.
uint slices_at(vec4 sphere, float near_m, float far_m, TileBounds b) {
    const float at_m = dot(b.axis, sphere.xyz) / dot(b.axis, b.axis);
    const vec3 aside = sphere.xyz - at_m * b.axis, sizes = abs(sphere.xyz);
    const float error_m = kPlaceError * (2.0 * (sizes.x + sizes.y + sizes.z) + sphere.w);
    const float radius_m = sphere.w + b.spread * clamp(sphere.w - sphere.z, 0.0, last_m) + error_m;
    const float rest = radius_m * radius_m - dot(aside, aside);
    const float half_m = sqrt(max(rest, 0.0) / dot(b.axis, b.axis));
    return rest < 0.0 ? 0u : slices_between(max(near_m, at_m - half_m), min(far_m, at_m + half_m)) & b.occupied;
}

// Finds the first and last row and column of each slice's pixels. Call after find_slices(); a barrier must follow.
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

// Returns true if the light, which is inside this sphere, reaches the box of one of these slices.
bool reaches_slice(vec4 sphere, Reach r, uint slices) {
    for (;;) {
        const int k = max(findLSB(slices), 0);
        const Box box = slice_box(k);
        if (slices != 0u && sphere_meets(sphere, box) && reaches(r, box)) return true;
        slices &= slices - 1u;
        if (slices == 0u) return false;
    }
}
