#include "scene/pictures/jpeg_decode.h"

#include <array>
#include <csetjmp>
#include <cstdio>
#include <cstdlib>
// The standard headers must come before jpeglib.h, which uses FILE and size_t without including their
// headers.
#include <jerror.h>
#include <jpeglib.h>

namespace weft::scene {
namespace {

// Memory of libjpeg's pools and tables in bytes, in addition to the memory for rows and coefficients.
constexpr uint64_t kJpegLibraryBytes = 1 << 20;
// Upper limit for the scans of a progressive picture. Each scan processes the whole picture, so many scans
// cost much time. Encoders usually write about ten scans.
constexpr int kMostScans = 100;

// State of the decoder. libjpeg reports an error to fail(), which uses longjmp. longjmp calls no destructors.
// So the functions between setjmp and longjmp on the call stack must not own resources.
struct JpegReader {
    jpeg_decompress_struct info{};
    jpeg_error_mgr errors{};
    jpeg_progress_mgr progress{};
    std::jmp_buf way_out{};
    std::array<char, JMSG_LENGTH_MAX> error{};
    std::span<const uint8_t> encoded;
    uint8_t* rgba = nullptr;
    JSAMPLE* cmyk_row = nullptr;
};

JpegReader& reader_of(j_common_ptr common) {
    return *static_cast<JpegReader*>(common->client_data);
}

[[noreturn]] void fail(j_common_ptr common) {
    JpegReader& reader = reader_of(common);
    common->err->format_message(common, reader.error.data());
    std::longjmp(reader.way_out, 1);  // NOLINT: libjpeg requires longjmp after an error
}

[[noreturn]] void fail_with(JpegReader& reader, const char* text) {
    std::snprintf(reader.error.data(), reader.error.size(), "%s", text);
    std::longjmp(reader.way_out, 1);  // NOLINT: libjpeg requires longjmp after an error
}

// Receives libjpeg's messages; a negative `level` is a warning. If a file is cut off, libjpeg only warns and
// fills the rest of the picture with invented data. Here this warning becomes an error.
void hear(j_common_ptr common, int level) {
    if (level < 0 && common->err->msg_code == JWRN_JPEG_EOF)
        fail_with(reader_of(common), "the file ends before the end of the picture");
}

void count_scans(j_common_ptr common) {
    JpegReader& reader = reader_of(common);
    if (reader.info.input_scan_number > kMostScans) fail_with(reader, "the file has more than 100 scans");
}

uint64_t padded(uint32_t side_px) {
    return (uint64_t{side_px} + 63) / 64 * 64;
}

// Memory in bytes that the decoder needs for rows during colour conversion, and for the coefficients if the
// picture has several scans.
uint64_t decoder_bytes(jpeg_decompress_struct& info) {
    const auto channels = static_cast<uint64_t>(info.num_components);
    const uint64_t row_bytes = padded(info.image_width) * channels;
    const bool keeps_coefficients = jpeg_has_multiple_scans(&info) != 0;
    const uint64_t texels = keeps_coefficients ? padded(info.image_width) * padded(info.image_height) : 0;
    return kJpegLibraryBytes + row_bytes * 64 + texels * channels * sizeof(JCOEF);
}

void begin(JpegReader& reader) {
    jpeg_create_decompress(&reader.info);
    jpeg_mem_src(&reader.info, reader.encoded.data(), static_cast<unsigned long>(reader.encoded.size()));
    jpeg_read_header(&reader.info, TRUE);
}

// Reads the size of the picture into `size`. After a fault, stores the text of the fault in `reader.error`
// and returns false.
bool read_header(JpegReader& reader, ImageSize& size) {
    if (setjmp(reader.way_out) != 0) return false;  // NOLINT: libjpeg requires longjmp after an error
    begin(reader);
    size = {reader.info.image_width, reader.info.image_height, decoder_bytes(reader.info)};
    return true;
}

// Converts one row from CMYK to RGBA. The file's CMYK values are inverted, as Adobe's programs write them:
// 255 means no ink.
void write_cmyk_row(const JSAMPLE* cmyk, uint32_t width_px, uint8_t* rgba) {
    for (uint32_t x = 0; x < width_px; ++x, cmyk += 4, rgba += 4) {
        for (int c = 0; c < 3; ++c) rgba[c] = static_cast<uint8_t>((cmyk[c] * cmyk[3] + 127) / 255);
        rgba[3] = 255;
    }
}

// Decodes all rows; read_header() must have been called before. `most_bytes` is the limit for the memory of
// libjpeg. After a fault, stores the text of the fault in `reader.error` and returns false.
bool decode_jpeg_rows(JpegReader& reader, uint64_t most_bytes) {
    if (setjmp(reader.way_out) != 0) return false;  // NOLINT: libjpeg requires longjmp after an error
    jpeg_decompress_struct& info = reader.info;
    info.mem->max_memory_to_use = static_cast<long>(most_bytes);
    reader.progress.progress_monitor = count_scans;
    info.progress = &reader.progress;
    const bool is_cmyk = info.jpeg_color_space == JCS_CMYK || info.jpeg_color_space == JCS_YCCK;
    info.out_color_space = is_cmyk ? JCS_CMYK : JCS_EXT_RGBA;
    jpeg_start_decompress(&info);
    const size_t row_bytes = size_t{info.output_width} * 4;
    while (info.output_scanline < info.output_height) {
        uint8_t* target = reader.rgba + info.output_scanline * row_bytes;
        JSAMPROW row = is_cmyk ? reader.cmyk_row : target;
        if (jpeg_read_scanlines(&info, &row, 1) != 1)
            fail_with(reader, "the file ends before the end of the picture");
        if (is_cmyk) write_cmyk_row(reader.cmyk_row, info.output_width, target);
    }
    return true;
}

void prepare(JpegReader& reader, std::span<const uint8_t> encoded) {
    reader.encoded = encoded;
    reader.info.err = jpeg_std_error(&reader.errors);
    reader.info.client_data = &reader;
    reader.errors.error_exit = fail;
    reader.errors.emit_message = hear;
}

class OpenJpegReader {
 public:
    explicit OpenJpegReader(std::span<const uint8_t> encoded) { prepare(reader_, encoded); }
    ~OpenJpegReader() { jpeg_destroy_decompress(&reader_.info); }
    OpenJpegReader(const OpenJpegReader&) = delete;
    OpenJpegReader& operator=(const OpenJpegReader&) = delete;

    JpegReader& get() { return reader_; }

 private:
    JpegReader reader_;
};

bool begins_as_jpeg(std::span<const uint8_t> encoded) {
    return encoded.size() >= 3 && encoded[0] == 0xFF && encoded[1] == 0xD8 && encoded[2] == 0xFF;
}

}  // namespace

std::optional<ImageSize> read_jpeg_size(std::span<const uint8_t> encoded) {
    if (!begins_as_jpeg(encoded)) return std::nullopt;
    OpenJpegReader reader(encoded);
    ImageSize size;
    if (!read_header(reader.get(), size)) return std::nullopt;
    return size;
}

DecodedImage decode_jpeg(std::span<const uint8_t> encoded) {
    DecodedImage result;
    if (!begins_as_jpeg(encoded)) {
        result.error = "the file is neither PNG nor JPEG";
        return result;
    }
    OpenJpegReader reader(encoded);
    ImageSize size;
    if (read_header(reader.get(), size)) {
        std::vector<uint8_t> rgba(size.texels() * 4);
        std::vector<JSAMPLE> row(size_t{size.width_px} * 4);
        reader.get().rgba = rgba.data();
        reader.get().cmyk_row = row.data();
        if (decode_jpeg_rows(reader.get(), size.decoder_bytes)) {
            result.size = size;
            result.rgba = std::move(rgba);
            return result;
        }
    }
    result.error = reader.get().error.data();
    return result;
}

}  // namespace weft::scene
