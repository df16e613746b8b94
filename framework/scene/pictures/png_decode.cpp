#include "scene/pictures/png_decode.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <bit>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <string_view>

namespace weft::scene {
namespace {

constexpr std::string_view kSignature("\x89PNG\r\n\x1a\n", 8);
// Byte offsets of fields in the file. The width and the height are the first fields of the IHDR chunk. They
// follow the signature (8 bytes) and the length and name of the chunk (8 bytes).
constexpr size_t kWidthAt = 16, kHeightAt = 20, kDepthAt = 24, kColorTypeAt = 25;
constexpr size_t kAroundChunkBytes = 12;  // Size of the length, the name and the checksum of a chunk.
constexpr uint32_t kMaxSide_px = 0x7FFFFFFF;
// Memory in bytes of libpng's structures and of zlib's window and tables.
constexpr uint64_t kPngLibraryBytes = 256 << 10;
// Upper limit in bytes for the memory that libpng may allocate for one chunk. The chunks that the decoder
// reads (PLTE, tRNS) have at most 768 bytes.
constexpr png_alloc_size_t kChunkBytes = 64 << 10;

// holds_more_than_its_size_needs() adds this number of bytes to its limit. In a short stream, the tables of
// the compression may be larger than the data.
constexpr uint64_t kLeastDataBytes = 512;

uint32_t big_endian(std::span<const uint8_t> encoded, size_t at) {
    return uint32_t{encoded[at]} << 24 | uint32_t{encoded[at + 1]} << 16 | uint32_t{encoded[at + 2]} << 8 |
           uint32_t{encoded[at + 3]};
}

// Returns an upper limit for the inflated picture in bytes. Each row has one extra byte for its filter. The
// function adds five bytes per row instead of one, because an interlaced picture has more and shorter rows.
uint64_t inflated_bytes(std::span<const uint8_t> encoded, const ImageSize& size) {
    constexpr std::array<uint64_t, 7> kChannels{1, 0, 3, 1, 2, 0, 4};
    const uint8_t color_type = encoded[kColorTypeAt];
    const uint64_t channels = color_type < kChannels.size() ? kChannels[color_type] : 0;
    const uint64_t row_bytes = (size.width_px * channels * encoded[kDepthAt] + 7) / 8;
    return (row_bytes + 5) * size.height_px;
}

uint64_t compressed_bytes(std::span<const uint8_t> encoded) {
    uint64_t sum_bytes = 0;
    for (size_t at = kSignature.size(); encoded.size() - at >= kAroundChunkBytes;) {
        const uint64_t length = big_endian(encoded, at);
        if (std::memcmp(encoded.data() + at + 4, "IDAT", 4) == 0) sum_bytes += length;
        if (length > encoded.size() - at - kAroundChunkBytes) break;
        at += kAroundChunkBytes + length;
    }
    return sum_bytes;
}

// Returns true if the file has more compressed data than its picture can need. Such a file would cost much
// time to decode: libpng inflates all data, even after the last row, and compressed data can expand a
// thousandfold.
bool holds_more_than_its_size_needs(std::span<const uint8_t> encoded, const ImageSize& size) {
    return compressed_bytes(encoded) > 2 * inflated_bytes(encoded, size) + kLeastDataBytes;
}

// State of the decoder. libpng reports an error to fail(), which uses longjmp to return to decode_png_rows().
// longjmp calls no destructors. So the functions between decode_png_rows() and fail() on the call stack must
// not own resources.
struct PngReader {
    std::span<const uint8_t> encoded;
    size_t at = 0;
    std::array<char, 128> error{};
    png_structp png = nullptr;
    png_infop info = nullptr;
    uint8_t* rgba = nullptr;
    bool wide = false;  // True: channels have 16 bits, in the byte order of the machine.

    PngReader() = default;
    ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;
};

void fail(png_structp png, png_const_charp text) {
    auto* reader = static_cast<PngReader*>(png_get_error_ptr(png));
    std::snprintf(reader->error.data(), reader->error.size(), "%s", text);
    png_longjmp(png, 1);
}

void pass_over_warning(png_structp, png_const_charp) {}

void read_bytes(png_structp png, png_bytep out, size_t bytes) {
    auto* reader = static_cast<PngReader*>(png_get_io_ptr(png));
    if (bytes > reader->encoded.size() - reader->at)
        png_error(png, "the file ends before the end of the picture");
    std::memcpy(out, reader->encoded.data() + reader->at, bytes);
    reader->at += bytes;
}

void limit(png_structp png) {
    png_set_user_limits(png, kMaxSide_px, kMaxSide_px);
    png_set_chunk_malloc_max(png, kChunkBytes);
    // The count -1 means: discard all chunks that the decoder does not need.
    png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
}

void ask_for_rgba(png_structp png, bool wide) {
    png_set_expand(png);
    if (wide && std::endian::native == std::endian::little) png_set_swap(png);
    if (!wide) png_set_strip_16(png);
    png_set_gray_to_rgb(png);
    png_set_add_alpha(png, wide ? 0xFFFF : 0xFF, PNG_FILLER_AFTER);
}

// Decodes all rows into `reader.rgba`. The caller has allocated `reader.rgba` for `width` and `height`, the
// values from the header. After a fault, stores the text of the fault in `reader.error` and returns false.
bool decode_png_rows(PngReader& reader, uint32_t width, uint32_t height) {
    if (setjmp(png_jmpbuf(reader.png)) != 0) return false;  // NOLINT: libpng reports errors with longjmp
    limit(reader.png);
    png_set_read_fn(reader.png, &reader, read_bytes);
    png_read_info(reader.png, reader.info);
    ask_for_rgba(reader.png, reader.wide);
    const int passes = png_set_interlace_handling(reader.png);
    png_read_update_info(reader.png, reader.info);
    const size_t row_bytes = size_t{width} * (reader.wide ? 8 : 4);
    if (png_get_rowbytes(reader.png, reader.info) != row_bytes ||
        png_get_image_width(reader.png, reader.info) != width ||
        png_get_image_height(reader.png, reader.info) != height)
        png_error(reader.png, "the header contradicts the data");
    for (int pass = 0; pass < passes; ++pass)
        for (uint32_t y = 0; y < height; ++y) png_read_row(reader.png, reader.rgba + y * row_bytes, nullptr);
    return true;
}

}  // namespace

bool is_png(std::span<const uint8_t> encoded) {
    return encoded.size() >= kSignature.size() &&
           std::memcmp(encoded.data(), kSignature.data(), kSignature.size()) == 0;
}

std::optional<ImageSize> read_png_size(std::span<const uint8_t> encoded) {
    constexpr std::string_view kHeader("\0\0\0\x0dIHDR", 8);
    if (!is_png(encoded) || encoded.size() <= kColorTypeAt ||
        std::memcmp(encoded.data() + kSignature.size(), kHeader.data(), kHeader.size()) != 0)
        return std::nullopt;
    ImageSize size{big_endian(encoded, kWidthAt), big_endian(encoded, kHeightAt), 0};
    if (size.width_px == 0 || size.height_px == 0 || size.width_px > kMaxSide_px ||
        size.height_px > kMaxSide_px)
        return std::nullopt;
    // The decoder keeps the current and the previous row, each with four channels of two bytes: 16 bytes per
    // column.
    size.decoder_bytes = kPngLibraryBytes + uint64_t{size.width_px} * 16;
    return size;
}

namespace {

// Decodes the picture to four channels of the type Channel. `Decoded` is DecodedImage or DecodedPng16.
template <class Channel, class Decoded>
Decoded decode_to(std::span<const uint8_t> encoded) {
    Decoded result;
    const std::optional<ImageSize> size = read_png_size(encoded);
    if (!size) {
        result.error = "the header is truncated or invalid";
        return result;
    }
    if (holds_more_than_its_size_needs(encoded, *size)) {
        result.error = "the file has more data than a picture of its size can need";
        return result;
    }
    std::vector<Channel> rgba(size->texels() * 4);
    PngReader reader;
    reader.encoded = encoded;
    reader.rgba = reinterpret_cast<uint8_t*>(rgba.data());
    reader.wide = sizeof(Channel) == 2;
    reader.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &reader, fail, pass_over_warning);
    if (reader.png != nullptr) reader.info = png_create_info_struct(reader.png);
    if (reader.info == nullptr) {
        result.error = "out of memory";
    } else if (decode_png_rows(reader, size->width_px, size->height_px)) {
        result.size = *size;
        result.rgba = std::move(rgba);
    } else {
        result.error = reader.error.data();
    }
    return result;
}

}  // namespace

DecodedImage decode_png(std::span<const uint8_t> encoded) {
    return decode_to<uint8_t, DecodedImage>(encoded);
}

bool is_png_16(std::span<const uint8_t> encoded) {
    return read_png_size(encoded) && encoded[kDepthAt] == 16;
}

DecodedPng16 decode_png_16(std::span<const uint8_t> encoded) {
    return decode_to<uint16_t, DecodedPng16>(encoded);
}

}  // namespace weft::scene
