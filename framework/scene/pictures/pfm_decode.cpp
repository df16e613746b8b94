#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>
#include <string_view>

#include "scene/pictures/float_picture.h"

namespace weft::scene {
namespace {

// Header of a PFM file: "PF" (colour) or "Pf" (grey), width, height and scale. One white-space character
// follows each of these words.
struct PfmHeader {
    uint32_t channels = 0;
    int64_t width_px = 0, height_px = 0;
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
    if (!number(word(), header.width_px) || !number(word(), header.height_px) || !number(word(), scale) ||
        !std::isfinite(scale) || scale == 0)
        return std::nullopt;
    header.little_endian = scale < 0;
    header.length_bytes = at;
    return header;
}

std::string_view text_of(std::span<const uint8_t> encoded) {
    return {reinterpret_cast<const char*>(encoded.data()), encoded.size()};
}

constexpr const char* kBadPfmHeader = "the header is not \"PF\" or \"Pf\", width, height and scale";

}  // namespace

FloatPictureHeader read_pfm_header(std::span<const uint8_t> encoded) {
    const std::optional<PfmHeader> header = pfm_header(text_of(encoded));
    if (!header) return {0, 0, 0, kBadPfmHeader};
    return {header->width_px, header->height_px, 0, {}};
}

FloatPicture decode_pfm(std::span<const uint8_t> encoded) {
    const std::optional<PfmHeader> header = pfm_header(text_of(encoded));
    if (!header) return {0, 0, {}, kBadPfmHeader};
    FloatPicture picture{
        static_cast<uint32_t>(header->width_px), static_cast<uint32_t>(header->height_px), {}, {}};
    const size_t row_bytes = size_t{picture.width_px} * header->channels * sizeof(float);
    const size_t wanted_bytes = header->length_bytes + row_bytes * picture.height_px;
    if (encoded.size() < wanted_bytes)
        return {0,
                0,
                {},
                "the file has " + std::to_string(encoded.size()) + " bytes; wanted " +
                    std::to_string(wanted_bytes)};
    const auto value = [&](size_t index) {
        std::array<uint8_t, 4> bytes;
        std::memcpy(bytes.data(), encoded.data() + header->length_bytes + index * sizeof(float), 4);
        if (header->little_endian != (std::endian::native == std::endian::little))
            std::reverse(bytes.begin(), bytes.end());
        return std::bit_cast<float>(bytes);
    };
    picture.texels.reserve(size_t{picture.width_px} * picture.height_px);
    for (size_t y = picture.height_px; y-- > 0;)
        for (size_t x = 0; x < picture.width_px; ++x) {
            const size_t first = (y * picture.width_px + x) * header->channels;
            const size_t step = header->channels == 3 ? 1 : 0;
            picture.texels.emplace_back(value(first), value(first + step), value(first + 2 * step), 1.0f);
        }
    return picture;
}

}  // namespace weft::scene
