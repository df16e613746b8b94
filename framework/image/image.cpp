#include "weft/image/image.h"

#include <cmath>

namespace weft::image {

bool same_size(const Image& a, const Image& b) {
    return a.width_px == b.width_px && a.height_px == b.height_px;
}

Image to_display(Image image) {
    if (image.encoding == Encoding::display) return image;
    for (size_t i = 0; i < image.texels.size(); ++i) image.texels[i] = display_texel(image, i);
    image.encoding = Encoding::display;
    return image;
}

glm::vec3 display_texel(const Image& image, size_t index) {
    glm::vec3 texel = image.texels[index];
    if (image.encoding == Encoding::display) return texel;
    for (int c = 0; c < 3; ++c) texel[c] = encode_srgb(glm::clamp(texel[c], 0.0f, 1.0f));
    return texel;
}

float encode_srgb(float linear) {
    return linear <= 0.0031308f ? linear * 12.92f : 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f;
}

float decode_srgb(float encoded) {
    return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

}  // namespace weft::image
