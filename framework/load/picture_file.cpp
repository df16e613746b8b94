#include "load/picture_file.h"

#include <optional>
#include <span>

#include "scene/pictures/float_picture.h"
#include "scene/pictures/png_decode.h"
#include "scene/pictures/radiance_picture.h"
#include "weft/scene/image_decode.h"

namespace weft {
namespace {

enum class PictureKind : uint8_t { none, png, jpeg, radiance, exr, pfm };

PictureKind kind_of(std::string_view bytes) {
    if (bytes.starts_with("\x89PNG")) return PictureKind::png;
    if (bytes.starts_with("\xff\xd8\xff")) return PictureKind::jpeg;
    if (bytes.starts_with("#?RADIANCE") || bytes.starts_with("#?RGBE")) return PictureKind::radiance;
    if (bytes.starts_with("\x76\x2f\x31\x01")) return PictureKind::exr;
    const bool is_pfm = bytes.starts_with("PF") || bytes.starts_with("Pf");
    return is_pfm && bytes.size() > 2 && (bytes[2] == '\n' || bytes[2] == ' ') ? PictureKind::pfm
                                                                               : PictureKind::none;
}

std::span<const uint8_t> octets(std::string_view bytes) {
    return {reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size()};
}

// `image` has four channels per texel; their largest value is `most`.
template <class Decoded>
PictureTexels from_channels(const Decoded& image, float most) {
    PictureTexels out{image.size.width_px, image.size.height_px, {}, most, image.error};
    out.values.reserve(image.rgba.size() / 4);
    for (size_t i = 0; i < image.rgba.size(); i += 4)
        out.values.push_back(
            glm::vec4(image.rgba[i], image.rgba[i + 1], image.rgba[i + 2], image.rgba[i + 3]) / most);
    return out;
}

PictureTexels from_rgba8(const scene::DecodedImage& image) {
    return from_channels(image, 255);
}

PictureTexels from_png(std::string_view bytes) {
    if (!scene::is_png_16(octets(bytes))) return from_rgba8(scene::decode_png(octets(bytes)));
    return from_channels(scene::decode_png_16(octets(bytes)), 65535);
}

PictureTexels from_radiance(std::string_view bytes) {
    const scene::RadianceHeader header = scene::read_radiance_header(octets(bytes));
    PictureTexels out{header.width_px, header.height_px, {}, 0, header.error};
    if (!header.error.empty()) return out;
    const scene::RadiancePicture picture = scene::decode_radiance(header, octets(bytes));
    out.fault = picture.error;
    out.values.reserve(picture.texels.size());
    for (const glm::vec3& texel : picture.texels) out.values.emplace_back(texel, 1.0f);
    return out;
}

PictureTexels from_floats(scene::FloatPicture picture) {
    return {picture.width_px, picture.height_px, std::move(picture.texels), 0, std::move(picture.error)};
}

PictureHeader checked(const scene::FloatPictureHeader& header) {
    constexpr int64_t kMostSide_px = 1 << 24;
    if (!header.error.empty()) return {0, 0, 0, header.error};
    if (header.width_px < 1 || header.height_px < 1 || header.width_px > kMostSide_px ||
        header.height_px > kMostSide_px)
        return {0, 0, 0,
                "according to its header, the picture is " + std::to_string(header.width_px) + " x " +
                    std::to_string(header.height_px)};
    const auto width = static_cast<uint32_t>(header.width_px),
               height = static_cast<uint32_t>(header.height_px);
    return {width, height, uint64_t{width} * height * header.decoder_bytes_per_texel, {}};
}

}  // namespace

PictureHeader read_picture_header(std::string_view bytes) {
    switch (kind_of(bytes)) {
        case PictureKind::none:
            break;
        case PictureKind::png:
        case PictureKind::jpeg: {
            const std::optional<scene::ImageSize> size = scene::read_image_size(octets(bytes));
            if (!size) return {0, 0, 0, "the header of the picture is truncated or invalid"};
            return {size->width_px, size->height_px, size->decoder_bytes + 8 * size->texels(), {}};
        }
        case PictureKind::radiance: {
            const scene::RadianceHeader header = scene::read_radiance_header(octets(bytes));
            return {header.width_px, header.height_px,
                    uint64_t{header.width_px} * header.height_px * sizeof(glm::vec3), header.error};
        }
        case PictureKind::exr:
            return checked(scene::read_exr_header(octets(bytes)));
        case PictureKind::pfm:
            return checked(scene::read_pfm_header(octets(bytes)));
    }
    return {};
}

PictureTexels decode_picture(std::string_view bytes) {
    switch (kind_of(bytes)) {
        case PictureKind::none:
            break;
        case PictureKind::png:
            return from_png(bytes);
        case PictureKind::jpeg:
            return from_rgba8(scene::decode_image(octets(bytes)));
        case PictureKind::radiance:
            return from_radiance(bytes);
        case PictureKind::exr:
            return from_floats(scene::decode_exr(octets(bytes)));
        case PictureKind::pfm:
            return from_floats(scene::decode_pfm(octets(bytes)));
    }
    return {0, 0, {}, 0, "the file is no longer a picture"};
}

}  // namespace weft
