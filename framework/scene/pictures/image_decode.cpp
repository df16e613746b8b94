#include "weft/scene/image_decode.h"

#include "scene/pictures/jpeg_decode.h"
#include "scene/pictures/png_decode.h"

namespace weft::scene {

std::optional<ImageSize> read_image_size(std::span<const uint8_t> encoded) {
    return is_png(encoded) ? read_png_size(encoded) : read_jpeg_size(encoded);
}

DecodedImage decode_image(std::span<const uint8_t> encoded) {
    return is_png(encoded) ? decode_png(encoded) : decode_jpeg(encoded);
}

}  // namespace weft::scene
