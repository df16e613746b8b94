#include "scene/image_decode.h"

#include <algorithm>
#include <climits>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string_view>

#include "scene/jpeg_tables.h"

namespace weft::scene {
namespace {

// Cleared: stb 2.27 decodes by whatever lies in tables that a JPEG's scan names and the file never defines.
void* bounded_malloc(size_t bytes) {
    return bytes > kMaxDecoderAllocationBytes ? nullptr : std::calloc(1, bytes);
}
void* bounded_realloc(void* old, size_t bytes) {
    return bytes > kMaxDecoderAllocationBytes ? nullptr : std::realloc(old, bytes);
}

}  // namespace
}  // namespace weft::scene

#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#define STBI_NO_LINEAR
#define STBI_NO_HDR
#define STB_IMAGE_STATIC
#define STBI_MALLOC weft::scene::bounded_malloc
#define STBI_REALLOC weft::scene::bounded_realloc
#define STBI_FREE std::free
#define STB_IMAGE_IMPLEMENTATION
#include <stb/stb_image.h>

namespace weft::scene {
namespace {

// stb refuses to tell the size of a PNG that it finds too large to decode, and the message should name it.
std::optional<ImageSize> read_png_size(std::span<const uint8_t> encoded) {
    constexpr std::string_view kStart("\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR", 16);
    if (encoded.size() < kStart.size() + 8 ||
        std::memcmp(encoded.data(), kStart.data(), kStart.size()) != 0) {
        return std::nullopt;
    }
    const auto big_endian = [&](size_t at) {
        return uint32_t{encoded[at]} << 24 | uint32_t{encoded[at + 1]} << 16 |
               uint32_t{encoded[at + 2]} << 8 | uint32_t{encoded[at + 3]};
    };
    const ImageSize size{big_endian(16), big_endian(20)};
    if (size.width_px == 0 || size.height_px == 0) return std::nullopt;
    return size;
}

// stb quotes the name of a chunk that it doesn't know, which is any four bytes of the file: a NUL ends the
// text before it has begun.
std::string failure_text() {
    const char* reason = stbi_failure_reason();
    const std::string text = reason != nullptr ? reason : "unknown format";
    const auto printable = [](char c) { return c >= ' ' && c <= '~'; };
    const bool sound = !text.empty() && std::all_of(text.begin(), text.end(), printable);
    return sound ? text : "a chunk has no name that PNG knows";
}

}  // namespace

std::optional<ImageSize> read_image_size(std::span<const uint8_t> encoded) {
    if (encoded.size() > INT_MAX) return std::nullopt;
    if (const std::optional<ImageSize> size = read_png_size(encoded)) return size;
    if (!jpeg_tables_fit(encoded)) return std::nullopt;
    int width = 0;
    int height = 0;
    int channels = 0;
    if (stbi_info_from_memory(encoded.data(), static_cast<int>(encoded.size()), &width, &height, &channels) ==
            0 ||
        width <= 0 || height <= 0) {
        return std::nullopt;
    }
    return ImageSize{static_cast<uint32_t>(width), static_cast<uint32_t>(height)};
}

DecodedImage decode_image(std::span<const uint8_t> encoded) {
    DecodedImage result;
    if (encoded.size() > INT_MAX) {
        result.error = "the encoded image has more than 2 GiB";
        return result;
    }
    if (!jpeg_tables_fit(encoded)) {
        result.error = "a Huffman table has more than 256 codes";
        return result;
    }
    int width = 0;
    int height = 0;
    int channels = 0;
    const std::unique_ptr<stbi_uc, decltype(&std::free)> pixels(
        stbi_load_from_memory(encoded.data(), static_cast<int>(encoded.size()), &width, &height, &channels,
                              4),
        &std::free);
    if (!pixels) {
        result.error = failure_text();
        return result;
    }
    result.size = {static_cast<uint32_t>(width), static_cast<uint32_t>(height)};
    result.rgba.assign(pixels.get(), pixels.get() + size_t{result.size.width_px} * result.size.height_px * 4);
    return result;
}

}  // namespace weft::scene
