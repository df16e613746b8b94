#include "render/jitter.h"

#include <algorithm>
#include <cmath>

namespace weft::render {
namespace {

glm::dvec2 halton(uint32_t index) {
    return {radical_inverse(index, 2), radical_inverse(index, 3)};
}

}  // namespace

double radical_inverse(uint32_t index, uint32_t base) {
    double value = 0, place = 1;
    for (; index > 0; index /= base) {
        place /= base;
        value += place * (index % base);
    }
    return value;
}

glm::vec2 jitter_px(uint64_t frame, uint32_t length) {
    if (length < 2) return {0, 0};
    glm::dvec2 mean(0);
    for (uint32_t i = 1; i <= length; ++i) mean += halton(i) / static_cast<double>(length);
    return halton(static_cast<uint32_t>(frame % length) + 1) - mean;
}

float mip_bias(uint32_t length) {
    // `length` samples in a pixel are √length samples along each axis, so each sample stands for a pixel that
    // is smaller by this factor. Moving pictures have only about 16 frames to average, so the bias is
    // limited.
    constexpr float kLeastBias = -2.0f;
    return length < 2 ? 0.0f : std::max(-0.5f * std::log2(static_cast<float>(length)), kLeastBias);
}

}  // namespace weft::render
