// Purpose: makes the bytes of small picture files for tests.
#pragma once

#include <cstdint>
#include <cstring>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "tests/viewer/pictures/bit_png.h"

namespace weft::test {

inline std::string big_endian(uint32_t value) {
    std::string out;
    for (int shift = 24; shift >= 0; shift -= 8) out.push_back(static_cast<char>((value >> shift) & 0xFF));
    return out;
}

// Returns an uncompressed PNG with 8 or 16 bits per channel. `samples` has width × height × channels values.
inline std::string plain_png(uint32_t width, uint32_t height, uint32_t bits, uint32_t channels,
                             const std::vector<uint32_t>& samples) {
    static constexpr char kColorTypes[] = {0, 4, 2, 6};  // Grey, grey with alpha, RGB, RGBA.
    std::string rows;
    for (size_t i = 0; i < samples.size(); ++i) {
        if (i % (size_t{width} * channels) == 0) rows.push_back('\0');  // The filter of the row: none.
        if (bits == 16) rows.push_back(static_cast<char>(samples[i] >> 8));
        rows.push_back(static_cast<char>(samples[i] & 0xFF));
    }
    uint32_t a = 1, b = 0;  // Adler-32 of the rows.
    for (const char c : rows) {
        a = (a + static_cast<uint8_t>(c)) % 65521;
        b = (b + a) % 65521;
    }
    std::string data("\x78\x01\x01", 3);
    const auto length = static_cast<uint16_t>(rows.size()), rest = static_cast<uint16_t>(~length);
    for (const uint16_t half : {length, rest})
        data += {static_cast<char>(half & 0xFF), static_cast<char>(half >> 8)};
    data += rows + big_endian(b << 16 | a);
    std::string header = big_endian(width) + big_endian(height);
    header += {static_cast<char>(bits), kColorTypes[channels - 1], 0, 0, 0};
    return "\x89PNG\r\n\x1a\n" + png_chunk("IHDR", header) + png_chunk("IDAT", data) + png_chunk("IEND", "");
}

// Returns a little-endian colour PFM. Row 0 of `texels` is the top row.
inline std::string plain_pfm(uint32_t width, uint32_t height, const std::vector<glm::vec3>& texels) {
    std::string out = "PF\n" + std::to_string(width) + " " + std::to_string(height) + "\n-1\n";
    for (uint32_t y = height; y-- > 0;)
        out.append(reinterpret_cast<const char*>(&texels[size_t{y} * width]), width * sizeof(glm::vec3));
    return out;
}

template <class T>
std::string raw_bytes(const std::vector<T>& items) {
    return {reinterpret_cast<const char*>(items.data()), items.size() * sizeof(T)};
}

}  // namespace weft::test
