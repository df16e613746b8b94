// Purpose: seeded, tileable noise for textures made at start-up. Every run gives the same numbers: only
// integer hashes and plain float arithmetic are used, no random numbers of the library.
// Shapes: a Field is a square of floats that wraps at its edges. Noise values lie in about 0..1 with mean
// 0.5. Sources: integer mixer by Wellons ("Prospecting for Hash Functions", 2018); gradient noise after
// Perlin, "Improving Noise" (SIGGRAPH 2002); cells after Worley, "A Cellular Texture Basis Function"
// (SIGGRAPH 1996).
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace weft::scene {

[[nodiscard]] uint32_t hash_u32(uint32_t x);
// Uniform in [0, 1) from two coordinates and a seed.
[[nodiscard]] float hash_unit(uint32_t a, uint32_t b, uint32_t seed);

// A short, copyable sequence of uniform numbers.
class Random {
 public:
    explicit Random(uint32_t seed) : state_(hash_u32(seed + 0x9e3779b9U)) {}
    [[nodiscard]] float unit();                        // [0, 1)
    [[nodiscard]] float range(float low, float high);  // [low, high)

 private:
    uint32_t state_;
};

struct Field {
    uint32_t size = 0;
    std::vector<float> values;  // row by row

    // Coordinates wrap; size is a power of two.
    [[nodiscard]] float at(uint32_t x, uint32_t y) const {
        return values[(y & (size - 1)) * size + (x & (size - 1))];
    }
};

// Parameters of fractal gradient noise: the first octave has `cells` lattice cells per side; each next octave
// doubles them.
struct FractalShape {
    uint32_t cells_x = 4;
    uint32_t cells_y = 4;
    uint32_t octaves = 5;
    float gain = 0.5f;
};
[[nodiscard]] Field fractal_noise(uint32_t size, const FractalShape& shape, uint32_t seed);

// Cell noise with one jittered point per cell: distance to the nearest and second nearest point, in cells,
// and the nearest point's id.
struct Cell {
    float nearest = 0;
    float second = 0;
    uint32_t id = 0;
};
[[nodiscard]] Cell worley(glm::vec2 position, uint32_t cells_x, uint32_t cells_y, uint32_t seed);

// Noise fields that all materials share at different offsets, so that a scene computes them only once.
struct NoiseBank {
    Field coarse;  // 3 cells across
    Field medium;  // 12 cells
    Field fine;    // 64 cells
    Field grain;   // 12 × 128 cells: stretched along x, for wood and brushed metal
};
[[nodiscard]] NoiseBank make_noise_bank(uint32_t size);

}  // namespace weft::scene
