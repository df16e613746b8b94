// Purpose: seeded, tileable noise for textures made at start-up. Every run gives the same numbers: they come
// from integer hashes, not from the random numbers of the C++ standard library. Shapes: a Field is a square
// of floats that wraps at its edges. The values of fractal_noise() are in 0..1 with a mean of about 0.5.
// Sources: integer mixer by Wellons ("Prospecting for Hash Functions", 2018); gradient noise after Perlin,
// "Improving Noise" (SIGGRAPH 2002); cells after Worley, "A Cellular Texture Basis Function" (SIGGRAPH 1996).
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace weft::scene {

[[nodiscard]] uint32_t hash_u32(uint32_t x);
// Returns a number in [0, 1) that depends only on two coordinates and a seed. The numbers are distributed
// uniformly.
[[nodiscard]] float hash_unit(uint32_t a, uint32_t b, uint32_t seed);

// Generates a sequence of uniformly distributed random numbers. A copy continues the sequence independently.
class Random {
 public:
    explicit Random(uint32_t seed) : state_(hash_u32(seed + 0x9e3779b9U)) {}
    [[nodiscard]] float unit();                        // Returns a number in [0, 1).
    [[nodiscard]] float range(float low, float high);  // Returns a number in [low, high).

 private:
    uint32_t state_;
};

struct Field {
    uint32_t size = 0;
    std::vector<float> values;  // The size × size values of the field, row by row.

    // Returns the value at (x, y). Coordinates wrap at the edges; `size` must be a power of two.
    [[nodiscard]] float at(uint32_t x, uint32_t y) const {
        return values[(y & (size - 1)) * size + (x & (size - 1))];
    }
};

// Parameters of fractal gradient noise. The first octave has cells_x × cells_y lattice cells. Each further
// octave has twice as many cells along each side (at most one per texel), and its amplitude is multiplied by
// `gain`.
struct FractalShape {
    uint32_t cells_x = 4;
    uint32_t cells_y = 4;
    uint32_t octaves = 5;
    float gain = 0.5f;
};
[[nodiscard]] Field fractal_noise(uint32_t size, const FractalShape& shape, uint32_t seed);

// Noise fields that all materials read at different offsets, so that a scene computes the fields only once.
struct NoiseBank {
    Field coarse;  // Noise with 3 cells per side in the first octave.
    Field medium;  // Noise with 12 cells per side in the first octave.
    Field fine;    // Noise with 64 cells per side in the first octave.
    // Noise with 6 × 96 cells in the first octave. The noise is stretched along x, for wood and brushed
    // metal.
    Field grain;
};
[[nodiscard]] NoiseBank make_noise_bank(uint32_t size);

}  // namespace weft::scene
