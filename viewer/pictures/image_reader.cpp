#include "viewer/pictures/image_reader.h"

#include <tinyexr.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <string_view>

#include "viewer/files/files.h"
#include "weft/image/flip.h"
#include "weft/scene/image_decode.h"

namespace weft::viewer {
namespace {

using image::Image;

struct Size {
    int64_t width_px = 0, height_px = 0;
};

Diagnostic unreadable(const std::string& path, const std::string& message, const std::string& help) {
    Diagnostic d;
    d.code = "X530";
    d.file = path;
    d.message = message;
    d.help = {help};
    return d;
}

Diagnostic undecodable(const std::string& path, const std::string& what, const std::string& why) {
    return unreadable(path, "the " + what + " picture cannot be decoded" + (why.empty() ? "" : ": " + why),
                      "write the picture again, in a form that `weft render -o` writes");
}

// Memory that reading a picture needs in addition to the decoded texels.
struct Reading {
    uint64_t file_bytes = 0;
    uint64_t bytes_per_texel = 0;
};

// Returns the peak memory for comparing two pictures of this size, in bytes. This is the larger of two sums:
// the memory while the second picture is read, and the memory of the comparison (texels, map of differences,
// its sorted copy and the heat map).
uint64_t comparing_bytes(const Size& size, const Reading& reading) {
    constexpr uint64_t kPictures = 2 * sizeof(glm::vec3), kMaps = 3 * sizeof(float) + sizeof(float);
    const auto width_px = static_cast<uint32_t>(size.width_px),
               height_px = static_cast<uint32_t>(size.height_px);
    const uint64_t texels = uint64_t{width_px} * height_px;
    const uint64_t while_read = reading.file_bytes + texels * (kPictures + reading.bytes_per_texel);
    return std::max(while_read, texels * (kPictures + kMaps) + image::flip_band_bytes(width_px, height_px));
}

// Returns an error if `size`, the size in the header of the file, is not positive or is too large. This check
// runs before memory for the texels is allocated, because the header of a small file can contain any size.
std::optional<Diagnostic> size_fault(const std::string& path, const Size& size, const Reading& reading,
                                     const PictureLimits& limits) {
    const auto side_limit_px = static_cast<int64_t>(limits.side_px);
    const bool fits = size.width_px > 0 && size.height_px > 0 && size.width_px <= side_limit_px &&
                      size.height_px <= side_limit_px;
    if (fits && comparing_bytes(size, reading) <= limits.memory_bytes) return std::nullopt;
    Diagnostic d;
    d.code = "X531";
    d.file = path;
    d.message = "according to its header, the picture is " + std::to_string(size.width_px) + "x" +
                std::to_string(size.height_px);
    d.message += fits ? "; comparing two pictures of this size needs " +
                            std::to_string(comparing_bytes(size, reading)) + " bytes, the limit is " +
                            std::to_string(limits.memory_bytes)
                      : "; a side must have 1 to " + std::to_string(limits.side_px) + " px";
    d.help = {"compare parts of the picture, " +
              raise_limit_text(fits ? "picture.memoryBytes" : "picture.sidePx")};
    return d;
}

std::span<const uint8_t> bytes_of(const std::string& content) {
    return {reinterpret_cast<const uint8_t*>(content.data()), content.size()};
}

Result<Image> read_png(const std::string& path, const std::string& content, const PictureLimits& limits) {
    const std::optional<scene::ImageSize> size = scene::read_image_size(bytes_of(content));
    if (!size) return undecodable(path, "PNG", "the file ends inside the header");
    const Reading reading{content.size() + size->decoder_bytes, 4};
    if (auto fault = size_fault(path, {size->width_px, size->height_px}, reading, limits)) return *fault;
    const scene::DecodedImage decoded = scene::decode_image(bytes_of(content));
    if (decoded.rgba.empty()) return undecodable(path, "PNG", decoded.error);
    Image result{decoded.size.width_px, decoded.size.height_px, image::Encoding::display, {}};
    result.texels.reserve(decoded.rgba.size() / 4);
    for (size_t i = 0; i < decoded.rgba.size(); i += 4)
        result.texels.push_back(glm::vec3(decoded.rgba[i], decoded.rgba[i + 1], decoded.rgba[i + 2]) /
                                255.0f);
    return result;
}

// Copies an error message of tinyexr and frees the original. The caller of tinyexr must free such messages.
std::string taken(const char* message) {
    std::string text = message ? message : "";
    FreeEXRErrorMessage(message);
    return text;
}

// Size of an EXR picture, and the memory that tinyexr needs to decode a texel. tinyexr stores every channel
// of every mip level as floats, and then red, green, blue and alpha a second time. All levels together have
// at most 4 times the texels of the largest level.
struct ExrShape {
    Size size;
    uint64_t bytes_per_texel = 0;
};

Result<ExrShape> exr_shape(const std::string& path, std::span<const uint8_t> bytes) {
    EXRVersion version{};
    if (ParseEXRVersionFromMemory(&version, bytes.data(), bytes.size()) != TINYEXR_SUCCESS)
        return undecodable(path, "EXR", "the file ends inside the header");
    if (version.multipart != 0 || version.non_image != 0)
        return undecodable(path, "EXR",
                           "the file has several parts or deep texels; wanted one part of plain texels");
    EXRHeader header;
    InitEXRHeader(&header);
    const char* why = nullptr;
    if (ParseEXRHeaderFromMemory(&header, &version, bytes.data(), bytes.size(), &why) != TINYEXR_SUCCESS)
        return undecodable(path, "EXR", taken(why));
    const EXRBox2i box = header.data_window;
    const auto channels = static_cast<uint64_t>(std::max(header.num_channels, 0));
    const uint64_t levels = header.tiled != 0 && header.tile_level_mode != TINYEXR_TILE_ONE_LEVEL ? 4 : 1;
    FreeEXRHeader(&header);
    return ExrShape{{int64_t{box.max_x} - box.min_x + 1, int64_t{box.max_y} - box.min_y + 1},
                    channels * levels * sizeof(float) + 4 * sizeof(float)};
}

Result<Image> read_exr(const std::string& path, const std::string& content, const PictureLimits& limits) {
    const std::span<const uint8_t> bytes = bytes_of(content);
    const Result<ExrShape> shape = exr_shape(path, bytes);
    if (!shape) return shape.errors();
    if (auto fault = size_fault(path, shape->size, {content.size(), shape->bytes_per_texel}, limits))
        return *fault;
    float* rgba = nullptr;
    int width = 0, height = 0;
    const char* why = nullptr;
    const int status = LoadEXRFromMemory(&rgba, &width, &height, bytes.data(), bytes.size(), &why);
    const std::unique_ptr<float, decltype(&std::free)> owner(rgba, &std::free);
    if (status != TINYEXR_SUCCESS) return undecodable(path, "EXR", taken(why));
    Image result{static_cast<uint32_t>(width), static_cast<uint32_t>(height), image::Encoding::linear, {}};
    const size_t count = size_t{result.width_px} * result.height_px;
    result.texels.reserve(count);
    for (size_t i = 0; i < count; ++i)
        result.texels.emplace_back(rgba[4 * i], rgba[4 * i + 1], rgba[4 * i + 2]);
    return result;
}

// Header of a PFM file: "PF" (colour) or "Pf" (grey), width, height and scale. One white-space character
// follows each of these words.
struct PfmHeader {
    uint32_t channels = 0;
    Size size;
    bool little_endian = false;
    size_t length_bytes = 0;
};

std::optional<PfmHeader> pfm_header(std::string_view content) {
    size_t at = 0;
    const auto word = [&] {
        const size_t end = std::min(content.find_first_of(" \t\r\n", at), content.size());
        const std::string_view text = content.substr(at, end - at);
        at = std::min(end + 1, content.size());
        return text;
    };
    const auto number = [](std::string_view text, auto& value) {
        return std::from_chars(text.data(), text.data() + text.size(), value).ptr ==
                   text.data() + text.size() &&
               !text.empty();
    };
    PfmHeader header;
    header.channels = word() == "PF" ? 3 : 1;
    float scale = 0;
    if (!number(word(), header.size.width_px) || !number(word(), header.size.height_px) ||
        !number(word(), scale) || !std::isfinite(scale) || scale == 0)
        return std::nullopt;
    header.little_endian = scale < 0;
    header.length_bytes = at;
    return header;
}

Result<Image> read_pfm(const std::string& path, const std::string& content, const PictureLimits& limits) {
    const std::optional<PfmHeader> header = pfm_header(content);
    if (!header)
        return undecodable(path, "PFM", "the header is not \"PF\" or \"Pf\", width, height and scale");
    if (auto fault = size_fault(path, header->size, {content.size(), 0}, limits)) return *fault;
    Image result{static_cast<uint32_t>(header->size.width_px),
                 static_cast<uint32_t>(header->size.height_px),
                 image::Encoding::linear,
                 {}};
    const size_t row_bytes = size_t{result.width_px} * header->channels * sizeof(float);
    const size_t wanted_bytes = header->length_bytes + row_bytes * result.height_px;
    if (content.size() < wanted_bytes)
        return undecodable(path, "PFM",
                           "the file has " + std::to_string(content.size()) + " bytes; wanted " +
                               std::to_string(wanted_bytes));
    const auto value = [&](size_t index) {
        std::array<char, 4> bytes;
        std::memcpy(bytes.data(), content.data() + header->length_bytes + index * sizeof(float), 4);
        if (header->little_endian != (std::endian::native == std::endian::little))
            std::reverse(bytes.begin(), bytes.end());
        return std::bit_cast<float>(bytes);
    };
    result.texels.reserve(size_t{result.width_px} * result.height_px);
    for (size_t y = result.height_px; y-- > 0;)
        for (size_t x = 0; x < result.width_px; ++x) {
            const size_t first = (y * result.width_px + x) * header->channels;
            const size_t step = header->channels == 3 ? 1 : 0;
            result.texels.emplace_back(value(first), value(first + step), value(first + 2 * step));
        }
    return result;
}

}  // namespace

Result<Image> read_image(const std::string& path, const PictureLimits& limits) {
    const std::optional<std::string> content = read_file(path, limits.file_bytes);
    if (!content)
        return unreadable(path, "the picture does not exist or cannot be read",
                          "check the path, which is relative to the current folder");
    if (content->size() > limits.file_bytes)
        return unreadable(path, "the file has more than " + std::to_string(limits.file_bytes) + " bytes",
                          "compare parts of the picture, " + raise_limit_text("picture.fileBytes"));
    try {
        if (content->starts_with("\x89PNG")) return read_png(path, *content, limits);
        if (content->starts_with("\x76\x2f\x31\x01")) return read_exr(path, *content, limits);
        if (content->starts_with("PF") || content->starts_with("Pf")) return read_pfm(path, *content, limits);
    } catch (const std::bad_alloc&) {
        Diagnostic fault = unreadable(path, "memory ran out while the picture was read",
                                      "close other programs, or compare parts of the picture");
        fault.code = "X571";
        return fault;
    } catch (const std::exception& error) {  // tinyexr may throw exceptions on broken files.
        return undecodable(path, "EXR", error.what());
    }
    return unreadable(path, "the file is not a PNG, EXR or PFM picture",
                      "convert the picture to PNG, EXR or PFM");
}

}  // namespace weft::viewer
