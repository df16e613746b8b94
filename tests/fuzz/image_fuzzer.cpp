// Bytes as a picture, through every reader that takes one from outside.
#include <cstdlib>
#include <span>

#include "fuzzed_file.h"
#include "image_reader.h"
#include "scene/image_decode.h"

namespace {

// Textures of glTF files: PNG and JPEG.
void read_as_texture(std::span<const uint8_t> bytes) {
    const auto size = weft::scene::read_image_size(bytes);
    if (!size || uint64_t{size->width_px} * size->height_px > (4u << 20)) return;
    const weft::scene::DecodedImage image = weft::scene::decode_image(bytes);
    if (image.rgba.size() != size_t{image.size.width_px} * image.size.height_px * 4) std::abort();
}

// Pictures that `weft compare` reads: PNG, EXR and PFM.
void read_as_picture(std::span<const uint8_t> bytes) {
    static const weft::fuzz::FuzzedFile file("picture");
    file.write(bytes);
    const auto image = weft::viewer::read_image(file.path().string());
    if (image && image->texels.size() != size_t{image->width_px} * image->height_px) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    // Another reader of foreign pictures gets its line here.
    read_as_texture({data, size});
    read_as_picture({data, size});
    return 0;
}
