// The depth slices of a tile that have a pixel, and a box around each. Needs pixel_box.glsl, reach.glsl and the images
// `depth`, `hiz` and `glassDepth`; for workgroups of 8 × 8 threads, one a tile.

const int kSlices = 32;
const int kTilePx = 16;

shared uint nearest_z, farthest_z;      // bits of floats, which sort as the floats do
shared uint slice_pixels[kSlices];      // columns in the lower half, rows in the upper; 0: no pixel
shared uint tile_pixels;
shared vec3 slice_low[kSlices], slice_high[kSlices];
shared uint occupied;

float first_m, slice_m;  // where the first slice begins, and how thick each is

// Of a pixel: from where to where it is to be lit; empty if it shows nothing.
struct Span {
    bool empty;
    float near_m, far_m;
};

ivec2 pixel_of(int i) {
    return ivec2(gl_WorkGroupID.xy) * kTilePx + ivec2(gl_LocalInvocationID.xy) + 8 * ivec2(i & 1, i >> 1);
}

Span span_of(ivec2 pixel) {
    if (any(greaterThanEqual(pixel, ivec2(view.viewport_px)))) return Span(true, 0.0, 0.0);
    const float z = texelFetch(depth, pixel, 0).r;
    if (!TRANSLUCENT) return Span(z <= 0.0, distance_of(z), distance_of(z));
    const float glass = texelFetch(glassDepth, pixel, 0).r;
    if (glass <= 0.0) return Span(true, 0.0, 0.0);
    return Span(false, distance_of(glass), z > 0.0 ? max(distance_of(z), distance_of(glass)) : kEndless);
}

int slice_of(float distance_m) { return int(clamp((distance_m - first_m) / slice_m, 0.0, float(kSlices - 1))); }

// Near and far of the transparent span; the sky doesn't count, but goes on behind the last slice.
bool find_translucent_range(out float near_m, out float far_m) {
    near_m = far_m = 0.0;
    if (!HAS_glassDepth) return false;
    if (gl_LocalInvocationIndex == 0u) {
        nearest_z = 0u;
        farthest_z = floatBitsToUint(1.0);
    }
    barrier();
    for (int i = 0; i < 4; ++i) {
        const ivec2 pixel = pixel_of(i);
        if (span_of(pixel).empty) continue;
        const float z = texelFetch(depth, pixel, 0).r, glass = texelFetch(glassDepth, pixel, 0).r;
        atomicMax(nearest_z, floatBitsToUint(glass));
        atomicMin(farthest_z, floatBitsToUint(z > 0.0 ? min(z, glass) : glass));
    }
    barrier();
    if (nearest_z == 0u) return false;
    near_m = distance_of(uintBitsToFloat(nearest_z));
    far_m = distance_of(uintBitsToFloat(farthest_z));
    return true;
}

bool find_range(out float near_m, out float far_m) {
    if (TRANSLUCENT) return find_translucent_range(near_m, far_m);
    const vec2 range = texelFetch(hiz, ivec2(gl_WorkGroupID.xy), 0).rg;
    near_m = distance_of(range.x);
    far_m = distance_of(range.y);
    return range.x > 0.0;
}

void enter(ivec2 pixel, Span span) {
    const ivec2 in_tile = pixel & (kTilePx - 1);
    const uint bits = (1u << in_tile.x) | (1u << (16 + in_tile.y));
    const int last = slice_of(span.far_m);
    for (int k = slice_of(span.near_m); k <= last; ++k) atomicOr(slice_pixels[k], bits);
}

// Of the pixels in a word of columns and rows.
Slopes slopes_of_pixels(uint pixels) {
    const ivec2 tile = ivec2(gl_WorkGroupID.xy) * kTilePx;
    const uint columns = pixels & 0xFFFFu, rows = pixels >> 16;
    return slopes_of(tile + ivec2(findLSB(columns), findLSB(rows)), tile + ivec2(findMSB(columns), findMSB(rows)));
}

void make_box(int k) {
    const uint pixels = slice_pixels[k];
    if (pixels == 0u) return;
    const float near_m = first_m + slice_m * float(k);
    const bool last = k == kSlices - 1;
    const Box box = box_of(slopes_of_pixels(pixels), near_m, last && TRANSLUCENT ? kEndless : near_m + slice_m);
    slice_low[k] = box.low;
    slice_high[k] = box.high;
    atomicOr(tile_pixels, pixels);
    atomicOr(occupied, 1u << k);
}

// To be called by all threads. False, for all of them: the tile shows nothing that is lit.
bool find_slices() {
    float near_m, far_m;
    if (!find_range(near_m, far_m)) return false;
    first_m = near_m;
    // Not thinner than what single precision tells apart.
    slice_m = max((far_m - near_m) / float(kSlices), kPlaceError * far_m);
    if (gl_LocalInvocationIndex == 0u) tile_pixels = occupied = 0u;
    if (gl_LocalInvocationIndex < kSlices) slice_pixels[gl_LocalInvocationIndex] = 0u;
    barrier();
    for (int i = 0; i < 4; ++i) {
        const ivec2 pixel = pixel_of(i);
        const Span span = span_of(pixel);
        if (!span.empty) enter(pixel, span);
    }
    barrier();
    if (gl_LocalInvocationIndex < kSlices) make_box(int(gl_LocalInvocationIndex));
    barrier();
    return true;
}

Slopes tile_slopes() { return slopes_of_pixels(tile_pixels); }

bool reaches_slice(Reach r) {
    for (uint todo = occupied; todo != 0u; todo &= todo - 1u) {
        const int k = findLSB(todo);
        if (reaches(r, Box(slice_low[k], slice_high[k]))) return true;
    }
    return false;
}
