// Decodes the fuzzer's bytes with each reader of untrusted picture files: textures of glTF files,
// environments, and the pictures of `weft compare`.
#include <cstdlib>
#include <span>

#include "scene/pictures/light_pictures.h"
#include "scene/pictures/load_environment.h"
#include "scene/pictures/mip_chain.h"
#include "tests/fuzz/fuzzed_file.h"
#include "viewer/pictures/image_reader.h"
#include "weft/scene/image_decode.h"

namespace {

// Larger pictures are skipped, because most of the time would be spent on filling memory.
constexpr uint64_t kMostTexels = 1 << 20;

// Uses the picture as the projected picture of a light. light_pictures() resizes all projected pictures to
// one size.
void show_by_a_light(const weft::scene::DecodedImage& image) {
    constexpr uint64_t kMostForLights = 1 << 14;
    if (image.size.texels() > kMostForLights) return;
    weft::scene::Scene scene;
    weft::scene::Texture& texture = scene.textures.emplace_back();
    texture.width_px = image.size.width_px;
    texture.height_px = image.size.height_px;
    texture.color_space = weft::scene::ColorSpace::srgb;
    texture.mips = weft::scene::build_mip_chain(texture.width_px, texture.height_px, image.rgba,
                                                {weft::scene::TexelMeaning::srgb_color, -1});
    scene.light_functions.emplace_back().picture = 0;
    if (weft::scene::light_pictures(scene).layers != 1) std::abort();
}

// Reads the bytes as a texture of a glTF file, which is PNG or JPEG.
void read_as_texture(std::span<const uint8_t> bytes) {
    const auto size = weft::scene::read_image_size(bytes);
    if (!size || uint64_t{size->width_px} * size->height_px > kMostTexels) return;
    const weft::scene::DecodedImage image = weft::scene::decode_image(bytes);
    const size_t expected = size_t{size->width_px} * size->height_px * 4;
    if (image.rgba.empty() ? image.error.empty() : image.rgba.size() != expected) std::abort();
    if (!image.rgba.empty()) show_by_a_light(image);
}

// Reads the file as an environment, which is a Radiance picture (.hdr).
void read_as_environment(const std::filesystem::path& file) {
    weft::scene::SceneLimits limits;
    limits.image_side_px = 4096;
    limits.memory_bytes = kMostTexels * 32;
    const auto environment = weft::scene::load_environment(file, limits);
    if (!environment && environment.errors().empty()) std::abort();
}

// Reads the file as a picture for `weft compare`, which reads PNG, EXR and PFM.
void read_as_picture(const std::filesystem::path& file) {
    weft::PictureLimits limits;
    limits.memory_bytes = 256 << 20;
    const auto image = weft::viewer::read_image(file.string(), limits);
    if (image && image->texels.size() != size_t{image->width_px} * image->height_px) std::abort();
}

}  // namespace

// LeakSanitizer must ignore leaks of tinyexr. For a broken file, tinyexr does not free its header (about one
// kilobyte). This does no harm, because `weft compare` ends right after it has failed to read a file.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libtinyexr";
}

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    static const weft::fuzz::FuzzedFile file("picture");
    file.write({data, size});
    read_as_texture({data, size});
    read_as_environment(file.path());
    read_as_picture(file.path());
    return 0;
}
