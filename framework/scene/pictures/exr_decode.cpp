#include <tinyexr.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <memory>
#include <new>

#include "scene/pictures/float_picture.h"

namespace weft::scene {
namespace {

// Copies an error message of tinyexr and frees the original. The caller of tinyexr must free such messages.
std::string taken(const char* message) {
    std::string text = message ? message : "";
    FreeEXRErrorMessage(message);
    return text;
}

FloatPictureHeader parse_exr_header(std::span<const uint8_t> encoded) {
    EXRVersion version{};
    if (ParseEXRVersionFromMemory(&version, encoded.data(), encoded.size()) != TINYEXR_SUCCESS)
        return {0, 0, 0, "the file ends inside the header"};
    if (version.multipart != 0 || version.non_image != 0)
        return {0, 0, 0, "the file has several parts or deep texels; wanted one part of plain texels"};
    EXRHeader header;
    InitEXRHeader(&header);
    const char* why = nullptr;
    if (ParseEXRHeaderFromMemory(&header, &version, encoded.data(), encoded.size(), &why) != TINYEXR_SUCCESS)
        return {0, 0, 0, taken(why)};
    const EXRBox2i box = header.data_window;
    const auto channels = static_cast<uint64_t>(std::max(header.num_channels, 0));
    // tinyexr stores every channel of every mip level as floats, and then red, green, blue and alpha a second
    // time. All levels together have at most 4 times the texels of the largest level.
    const uint64_t levels = header.tiled != 0 && header.tile_level_mode != TINYEXR_TILE_ONE_LEVEL ? 4 : 1;
    FreeEXRHeader(&header);
    return {int64_t{box.max_x} - box.min_x + 1,
            int64_t{box.max_y} - box.min_y + 1,
            channels * levels * sizeof(float) + 4 * sizeof(float),
            {}};
}

FloatPicture load_exr(std::span<const uint8_t> encoded) {
    float* rgba = nullptr;
    int width = 0, height = 0;
    const char* why = nullptr;
    const int status = LoadEXRFromMemory(&rgba, &width, &height, encoded.data(), encoded.size(), &why);
    const std::unique_ptr<float, decltype(&std::free)> owner(rgba, &std::free);
    if (status != TINYEXR_SUCCESS) return {0, 0, {}, taken(why)};
    FloatPicture picture{static_cast<uint32_t>(width), static_cast<uint32_t>(height), {}, {}};
    const size_t count = size_t{picture.width_px} * picture.height_px;
    picture.texels.reserve(count);
    for (size_t i = 0; i < count; ++i)
        picture.texels.emplace_back(rgba[4 * i], rgba[4 * i + 1], rgba[4 * i + 2], rgba[4 * i + 3]);
    return picture;
}

// tinyexr may throw exceptions on broken files.
template <class Function>
auto without_exceptions(const Function& function) -> decltype(function()) {
    decltype(function()) failed;
    try {
        return function();
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        failed.error = error.what();
    }
    return failed;
}

}  // namespace

FloatPictureHeader read_exr_header(std::span<const uint8_t> encoded) {
    return without_exceptions([&] { return parse_exr_header(encoded); });
}

FloatPicture decode_exr(std::span<const uint8_t> encoded) {
    return without_exceptions([&] { return load_exr(encoded); });
}

}  // namespace weft::scene
