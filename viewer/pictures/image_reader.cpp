#include "viewer/pictures/image_reader.h"

#include <algorithm>
#include <new>
#include <optional>
#include <span>

#include "scene/pictures/float_picture.h"
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
// sorted copy of this map, heat map, and temporary memory of FLIP).
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

using ReadHeader = scene::FloatPictureHeader (*)(std::span<const uint8_t>);
using Decode = scene::FloatPicture (*)(std::span<const uint8_t>);

Result<Image> read_floats(const std::string& path, const char* kind, ReadHeader read_header, Decode decode,
                          const std::string& content, const PictureLimits& limits) {
    const scene::FloatPictureHeader header = read_header(bytes_of(content));
    if (!header.error.empty()) return undecodable(path, kind, header.error);
    const Reading reading{content.size(), header.decoder_bytes_per_texel + sizeof(glm::vec4)};
    if (auto fault = size_fault(path, {header.width_px, header.height_px}, reading, limits)) return *fault;
    const scene::FloatPicture picture = decode(bytes_of(content));
    if (!picture.error.empty()) return undecodable(path, kind, picture.error);
    Image result{picture.width_px, picture.height_px, image::Encoding::linear, {}};
    result.texels.reserve(picture.texels.size());
    for (const glm::vec4& texel : picture.texels) result.texels.emplace_back(texel);
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
        if (content->starts_with("\x76\x2f\x31\x01"))
            return read_floats(path, "EXR", scene::read_exr_header, scene::decode_exr, *content, limits);
        if (content->starts_with("PF") || content->starts_with("Pf"))
            return read_floats(path, "PFM", scene::read_pfm_header, scene::decode_pfm, *content, limits);
    } catch (const std::bad_alloc&) {
        Diagnostic fault = unreadable(path, "memory ran out while the picture was read",
                                      "close other programs, or compare parts of the picture");
        fault.code = "X571";
        return fault;
    }
    return unreadable(path, "the file is not a PNG, EXR or PFM picture",
                      "convert the picture to PNG, EXR or PFM");
}

}  // namespace weft::viewer
