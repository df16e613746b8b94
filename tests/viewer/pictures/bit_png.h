// Large pictures in small files: black PNGs of one bit per texel, with the best compression of fixed Huffman
// codes.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace weft::test {

// A completely valid file of width × height texels.
[[nodiscard]] std::string black_png(uint32_t width_px, uint32_t height_px);

// A file with one texel according to its header, whose data inflates to `data_bytes`.
[[nodiscard]] std::string swollen_png(uint64_t data_bytes);

// A chunk with its length and checksum.
[[nodiscard]] std::string png_chunk(std::string_view type, std::string_view data);

}  // namespace weft::test
