// The depth slices of a tile that have a pixel, with the pixels' rows and columns. Needs pixel_box.glsl, reach.glsl,
// sorted_list.glsl and the images `depth`, `hiz` and `glassDepth`; for workgroups of 8 × 4 threads, one a tile, which have
// two squares of 2 × 2 pixels each.

const int kSlices = 32;
const int kTilePx = 16;

shared uint slice_pixels[kSlices];  // columns in the lower half, rows in the upper; 0: no pixel
shared uint occupied;               // a bit for each slice that has a pixel
shared uint nearest_z, farthest_z;  // bits of floats, which sort as the floats do

float first_m, slice_m, last_m;     // where the first slice begins, how thick each is, where the last one ends

struct TileBounds {
    SidePlanes sides;
    Box box;
    uint occupied;
};

// The pixels of a square in the order of textureGather.
const ivec2 kGathered[4] = ivec2[](ivec2(0, 1), ivec2(1, 1), ivec2(1, 0), ivec2(0, 0));

ivec2 tile_origin() { return ivec2(gl_WorkGroupID.xy) * kTilePx; }

ivec2 square_in_tile(int i) { return (ivec2(gl_LocalInvocationID.xy) + ivec2(0, 4 * i)) * 2; }

// 0 outside the picture.
vec4 gather_depth(sampler2D image, ivec2 square) {
    const vec4 z = textureGather(image, vec2(square + 1) * view.inverse_viewport);
    const bvec2 inside = lessThan(square + 1, ivec2(view.viewport_px));
    const bvec4 seen = bvec4(inside.y, inside.x && inside.y, inside.x, true);
    return any(greaterThanEqual(square, ivec2(view.viewport_px))) ? vec4(0.0) : mix(vec4(0.0), z, seen);
}

int slice_of(float distance_m) { return int(clamp((distance_m - first_m) / slice_m, 0.0, float(kSlices - 1))); }

uint pixel_bits(ivec2 in_tile) { return (1u << in_tile.x) | (1u << (16 + in_tile.y)); }

// Pixels in one slice are entered together. The slices, as bits.
uint enter_opaque(ivec2 square) {
    const vec4 z = gather_depth(depth, tile_origin() + square);
    uint entered = 0u;
    ivec4 slice;
    for (int i = 0; i < 4; ++i) slice[i] = z[i] > 0.0 ? slice_of(distance_of(z[i])) : -1;
    for (int k = max(max(slice.x, slice.y), max(slice.z, slice.w)); k >= 0;) {
        uint pixels = 0u;
        int next = -1;
        for (int i = 0; i < 4; ++i) {
            if (slice[i] == k) pixels |= pixel_bits(square + kGathered[i]);
            if (slice[i] < k) next = max(next, slice[i]);
        }
        atomicOr(slice_pixels[k], pixels);
        entered |= 1u << k;
        k = next;
    }
    return entered;
}

// All slices from the transparent surface to the opaque one, or to the last; as bits, too.
uint enter_translucent(ivec2 square) {
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

// From the nearest transparent surface to what is farthest, without the sky.
vec2 translucent_range() {
    for (int s = 0; s < 2; ++s) {
        const ivec2 square = tile_origin() + square_in_tile(s);
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

// False, for all threads: the tile shows nothing that is lit. Ends with a barrier.
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
    // No slice is thinner than what single precision tells apart.
    slice_m = max((distance_of(range.y) - first_m) / float(kSlices), kPlaceError * distance_of(range.y));
    last_m = TRANSLUCENT ? kEndless : first_m + slice_m * float(kSlices);
    uint entered = 0u;
    for (int s = 0; s < 2; ++s)
        entered |= TRANSLUCENT ? enter_translucent(square_in_tile(s)) : enter_opaque(square_in_tile(s));
    if (entered != 0u) atomicOr(occupied, entered);
    barrier();
    return range.x > 0.0;
}

TileBounds tile_bounds() {
    const ivec2 last = min(tile_origin() + kTilePx, ivec2(view.viewport_px)) - 1;
    const Slopes slopes = slopes_of(tile_origin(), last);
    return TileBounds(planes_of(slopes), box_of(slopes, first_m, last_m), occupied);
}

// The slices that a sphere may reach into, as bits. What is beyond an edge by little is still at it: places are rounded.
uint slices_at(vec4 sphere) {
    const float a = clamp((-sphere.z - sphere.w - first_m) / slice_m - 0.01, 0.0, float(kSlices - 1));
    const float b = clamp((-sphere.z + sphere.w - first_m) / slice_m + 0.01, 0.0, float(kSlices - 1));
    return (~0u << int(a)) & (~0u >> (kSlices - 1 - int(b)));
}

bool may_reach(vec4 sphere, TileBounds b) {
    return sphere_inside(sphere, b.sides) && sphere_meets(sphere, b.box) && (slices_at(sphere) & b.occupied) != 0u;
}

Box slice_box(int k) {
    const uint pixels = slice_pixels[k], columns = pixels & 0xFFFFu, rows = pixels >> 16;
    const Slopes slopes = slopes_of(tile_origin() + ivec2(findLSB(columns), findLSB(rows)),
                                    tile_origin() + ivec2(findMSB(columns), findMSB(rows)));
    const float near_m = first_m + slice_m * float(k);
    return box_of(slopes, near_m, k == kSlices - 1 ? last_m : near_m + slice_m);
}

// Slices are tried with the light's sphere first, and only where that meets one with the light itself.
bool reaches_slice(vec4 sphere, Reach r, TileBounds b) {
    const bool ball = r.cos_spread <= -1.0 && r.first == vec3(0.0);
    uint todo = slices_at(sphere) & b.occupied;
    if (!ball && !reaches(r, b.box)) todo = 0u;
    while (todo != 0u) {
        Box box;
        bool met = false;
        while (todo != 0u && !met) {
            box = slice_box(findLSB(todo));
            met = sphere_meets(sphere, box);
            todo &= todo - 1u;
        }
        if (met && (ball || reaches(r, box))) return true;
    }
    return false;
}
