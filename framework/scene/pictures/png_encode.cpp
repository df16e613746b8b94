#include "scene/pictures/png_encode.h"

#include <png.h>

namespace weft::scene {

Result<std::string> encode_png(uint32_t width_px, uint32_t height_px, std::span<const std::byte> rgba8) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = width_px;
    image.height = height_px;
    image.format = PNG_FORMAT_RGBA;  // sRGB, and alpha is not premultiplied.
    png_alloc_size_t length = PNG_IMAGE_PNG_SIZE_MAX(image);
    std::string encoded(length, '\0');
    const bool is_written =
        png_image_write_to_memory(&image, encoded.data(), &length, 0, rgba8.data(), 0, nullptr) != 0;
    if (!is_written) {
        Diagnostic d;
        d.code = "X510";
        d.message = std::string("the picture cannot be encoded: ") + image.message;
        d.help = {"make the picture smaller"};
        return d;
    }
    encoded.resize(length);
    return encoded;
}

}  // namespace weft::scene
