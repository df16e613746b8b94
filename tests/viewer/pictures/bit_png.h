// Makes large pictures in small files: black PNG files with one bit per texel, compressed as far as fixed
// Huffman codes allow.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace weft::test {

// Returns a valid PNG file of width × height black texels.
[[nodiscard]] std::string black_png(uint32_t width_px, uint32_t height_px);

// Returns a PNG file whose header gives the size 1 × 1, but whose image data inflates to `data_bytes` bytes.
[[nodiscard]] std::string swollen_png(uint64_t data_bytes);

// Returns a PNG chunk with its length and checksum.
[[nodiscard]] std::string png_chunk(std::string_view type, std::string_view data);

}  // namespace weft::test
