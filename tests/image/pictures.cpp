#include "tests/image/pictures.h"

#include <random>

namespace weft::image::test {

Image constant(uint32_t width_px, uint32_t height_px, glm::ivec3 rgb) {
    return {width_px, height_px, Encoding::display,
            std::vector<glm::vec3>(size_t{width_px} * height_px, glm::vec3(rgb) / 255.0f)};
}

Image noise(uint32_t width_px, uint32_t height_px, uint32_t seed) {
    std::mt19937 random(seed);
    Image image = constant(width_px, height_px, {0, 0, 0});
    for (glm::vec3& texel : image.texels)
        for (int c = 0; c < 3; ++c) texel[c] = static_cast<float>(random() % 256) / 255.0f;
    return image;
}

}  // namespace weft::image::test
