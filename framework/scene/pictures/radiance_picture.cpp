#include "scene/pictures/radiance_picture.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

namespace weft::scene {
namespace {

// Only rows with a number of texels from kShortestCoded to kLongestCoded may be run-length encoded.
constexpr uint32_t kShortestCoded = 8, kLongestCoded = 32767;
constexpr size_t kMaxHeaderBytes = 65536;
// EXPOSURE lines with a factor outside (1 / kMostExposure, kMostExposure) are ignored.
constexpr float kMostExposure = 1e8f;

class Lines {
 public:
    explicit Lines(std::string_view text) : text_(text) {}

    // Returns the next line of the text, or nullopt if the text ends before the end of a line.
    std::optional<std::string_view> next() {
        const size_t end = text_.find('\n', at_);
        if (end == std::string_view::npos) return std::nullopt;
        std::string_view line = text_.substr(at_, end - at_);
        at_ = end + 1;
        if (line.ends_with('\r')) line.remove_suffix(1);
        return line;
    }
    [[nodiscard]] size_t position() const { return at_; }

 private:
    std::string_view text_;
    size_t at_ = 0;
};

std::string_view without_spaces(std::string_view text) {
    while (text.starts_with(' ')) text.remove_prefix(1);
    return text;
}

template <class Number>
std::optional<Number> leading_number(std::string_view& text) {
    text = without_spaces(text);
    Number value{};
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (fault != std::errc{}) return std::nullopt;
    text.remove_prefix(static_cast<size_t>(end - text.data()));
    return value;
}

// Reads the resolution line, which has the form "-Y height +X width".
bool read_resolution(std::string_view line, RadianceHeader& header) {
    if (!line.starts_with("-Y ")) return false;
    line.remove_prefix(3);
    const auto height = leading_number<uint32_t>(line);
    line = without_spaces(line);
    if (!height || !line.starts_with("+X ")) return false;
    line.remove_prefix(3);
    const auto width = leading_number<uint32_t>(line);
    if (!width || *width == 0 || *height == 0) return false;
    header.width_px = *width;
    header.height_px = *height;
    return true;
}

std::string read_variables(Lines& lines, RadianceHeader& header) {
    constexpr std::string_view kFormat = "FORMAT=", kExposure = "EXPOSURE=";
    bool known = false;
    while (const std::optional<std::string_view> line = lines.next()) {
        if (line->empty()) return known ? "" : "the header has no line FORMAT=32-bit_rle_rgbe";
        if (line->starts_with(kFormat))
            known = without_spaces(line->substr(kFormat.size())) == "32-bit_rle_rgbe";
        if (!line->starts_with(kExposure)) continue;
        std::string_view text = line->substr(kExposure.size());
        const auto exposure = leading_number<float>(text);
        if (exposure && *exposure > 1 / kMostExposure && *exposure < kMostExposure)
            header.exposure *= *exposure;
    }
    return "the header is truncated";
}

// Reads bytes in order. ended() says whether a byte was requested after the end of the data.
class Source {
 public:
    Source(std::span<const uint8_t> bytes, size_t begin) : bytes_(bytes), at_(begin) {}

    uint8_t next() {
        if (at_ < bytes_.size()) return bytes_[at_++];
        ended_ = true;
        return 0;
    }
    [[nodiscard]] uint8_t peek(size_t ahead) const {
        return at_ + ahead < bytes_.size() ? bytes_[at_ + ahead] : uint8_t{0};
    }
    [[nodiscard]] bool ended() const { return ended_; }

 private:
    std::span<const uint8_t> bytes_;
    size_t at_ = 0;
    bool ended_ = false;
};

using Rgbe = std::array<uint8_t, 4>;

// Reads a run-length encoded row. Its first four bytes are skipped, because read_row() has checked them.
// After them the row stores each channel separately, as runs. A run begins with a byte `code`. If `code` is
// above 128, one byte follows, which is repeated code - 128 times. Otherwise `code` bytes follow.
bool read_coded_row(Source& source, std::vector<Rgbe>& row) {
    for (int i = 0; i < 4; ++i) source.next();
    for (size_t channel = 0; channel < 4; ++channel) {
        for (size_t x = 0; x < row.size();) {
            const uint8_t code = source.next();
            const size_t count = code > 128 ? code - 128u : code;
            if (count == 0 || count > row.size() - x) return false;
            const uint8_t repeated = code > 128 ? source.next() : uint8_t{0};
            for (size_t end = x + count; x < end; ++x)
                row[x][channel] = code > 128 ? repeated : source.next();
        }
    }
    return !source.ended();
}

bool read_row(Source& source, std::vector<Rgbe>& row) {
    const size_t width = row.size();
    // An encoded row begins with the bytes 2 and 2 and the width as a 16-bit big-endian number.
    const bool coded = width >= kShortestCoded && width <= kLongestCoded && source.peek(0) == 2 &&
                       source.peek(1) == 2 && source.peek(2) == width >> 8 && source.peek(3) == (width & 255);
    if (coded) return read_coded_row(source, row);
    for (Rgbe& texel : row)
        for (uint8_t& channel : texel) channel = source.next();
    return !source.ended();
}

glm::vec3 radiance_of(const Rgbe& texel, float exposure) {
    if (texel[3] == 0) return glm::vec3(0);
    // The stored exponent has a bias of 128, and the mantissas are fractions of 256 = 2^8: 128 + 8 = 136.
    const float unit = std::ldexp(1.0f, int{texel[3]} - 136) / exposure;
    return glm::vec3(texel[0], texel[1], texel[2]) * unit;
}

}  // namespace

RadianceHeader read_radiance_header(std::span<const uint8_t> encoded) {
    RadianceHeader header;
    const std::string_view text(reinterpret_cast<const char*>(encoded.data()),
                                std::min(encoded.size(), kMaxHeaderBytes));
    Lines lines(text);
    const std::optional<std::string_view> first = lines.next();
    if (!first || !(first->starts_with("#?RADIANCE") || first->starts_with("#?RGBE"))) {
        header.error = "the file does not begin with #?RADIANCE";
        return header;
    }
    header.error = read_variables(lines, header);
    if (!header.error.empty()) return header;
    const std::optional<std::string_view> resolution = lines.next();
    if (!resolution || !read_resolution(*resolution, header))
        header.error = "the size is not given in the form \"-Y height +X width\"";
    header.data_begin = lines.position();
    return header;
}

RadiancePicture decode_radiance(const RadianceHeader& header, std::span<const uint8_t> encoded) {
    RadiancePicture picture;
    picture.texels.reserve(size_t{header.width_px} * header.height_px);
    Source source(encoded, header.data_begin);
    std::vector<Rgbe> row(header.width_px);
    for (uint32_t y = 0; y < header.height_px; ++y) {
        if (!read_row(source, row)) {
            picture.texels.clear();
            picture.error = (source.ended() ? "the file ends in row " : "the encoding is broken in row ") +
                            std::to_string(y + 1) + " of " + std::to_string(header.height_px);
            return picture;
        }
        for (const Rgbe& texel : row) picture.texels.push_back(radiance_of(texel, header.exposure));
    }
    return picture;
}

}  // namespace weft::scene
