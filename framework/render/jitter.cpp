#include "render/jitter.h"

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

}  // namespace weft::render
