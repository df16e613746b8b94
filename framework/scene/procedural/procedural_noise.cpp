#include "scene/procedural/procedural_noise.h"

#include <algorithm>
#include <cmath>

namespace weft::scene {
namespace {

float fade(float t) {
    return t * t * t * (t * (t * 6 - 15) + 10);
}

// Adds one octave of gradient noise to `out`, multiplied by `amplitude`.
void add_gradient_octave(Field& out, uint32_t cells_x, uint32_t cells_y, float amplitude, uint32_t seed) {
    std::vector<glm::vec2> gradients(static_cast<size_t>(cells_x) * cells_y);
    for (uint32_t y = 0; y < cells_y; ++y) {
        for (uint32_t x = 0; x < cells_x; ++x) {
            const float angle = hash_unit(x, y, seed) * 6.2831853f;
            gradients[y * cells_x + x] = {std::cos(angle), std::sin(angle)};
        }
    }
    const float step_x = static_cast<float>(cells_x) / static_cast<float>(out.size);
    const float step_y = static_cast<float>(cells_y) / static_cast<float>(out.size);
    for (uint32_t y = 0; y < out.size; ++y) {
        const float fy = (static_cast<float>(y) + 0.5f) * step_y;
        const auto y0 = static_cast<uint32_t>(fy);
        const float ty = fy - static_cast<float>(y0);
        const float wy = fade(ty);
        const glm::vec2* low = &gradients[(y0 % cells_y) * cells_x];
        const glm::vec2* high = &gradients[((y0 + 1) % cells_y) * cells_x];
        for (uint32_t x = 0; x < out.size; ++x) {
            const float fx = (static_cast<float>(x) + 0.5f) * step_x;
            const auto x0 = static_cast<uint32_t>(fx);
            const uint32_t x1 = (x0 + 1) % cells_x;
            const float tx = fx - static_cast<float>(x0);
            const float wx = fade(tx);
            const float a = low[x0].x * tx + low[x0].y * ty;
            const float b = low[x1].x * (tx - 1) + low[x1].y * ty;
            const float c = high[x0].x * tx + high[x0].y * (ty - 1);
            const float d = high[x1].x * (tx - 1) + high[x1].y * (ty - 1);
            const float bottom = a + (b - a) * wx;
            const float top = c + (d - c) * wx;
            out.values[y * out.size + x] += amplitude * (bottom + (top - bottom) * wy);
        }
    }
}

}  // namespace

uint32_t hash_u32(uint32_t x) {
    x ^= x >> 16;
    x *= 0x7feb352dU;
    x ^= x >> 15;
    x *= 0x846ca68bU;
    x ^= x >> 16;
    return x;
}

float hash_unit(uint32_t a, uint32_t b, uint32_t seed) {
    return static_cast<float>(hash_u32(a + hash_u32(b + hash_u32(seed))) >> 8) / 16777216.0f;
}

float Random::unit() {
    state_ = state_ * 747796405U + 2891336453U;
    return static_cast<float>(hash_u32(state_) >> 8) / 16777216.0f;
}

float Random::range(float low, float high) {
    return low + (high - low) * unit();
}

Field fractal_noise(uint32_t size, const FractalShape& shape, uint32_t seed) {
    Field field{size, std::vector<float>(static_cast<size_t>(size) * size, 0.5f)};
    float total = 0;
    float amplitude = 1;
    for (uint32_t octave = 0; octave < shape.octaves; ++octave, amplitude *= shape.gain) total += amplitude;
    // Each octave rarely exceeds ±0.55 of its amplitude. So with a total amplitude of 0.9 the sum stays in
    // about 0.5 ± 0.5.
    amplitude = 0.9f / total;
    for (uint32_t octave = 0; octave < shape.octaves; ++octave, amplitude *= shape.gain) {
        add_gradient_octave(field, std::min(shape.cells_x << octave, size),
                            std::min(shape.cells_y << octave, size), amplitude, seed * 31 + octave);
    }
    for (float& value : field.values) value = std::clamp(value, 0.0f, 1.0f);
    return field;
}

NoiseBank make_noise_bank(uint32_t size) {
    return {fractal_noise(size, {3, 3, 6, 0.55f}, 11), fractal_noise(size, {12, 12, 5, 0.55f}, 23),
            fractal_noise(size, {64, 64, 3, 0.6f}, 37), fractal_noise(size, {6, 96, 3, 0.6f}, 53)};
}

}  // namespace weft::scene
