// Large pictures in small files: PNGs of one bit a texel, all black, compressed as far as fixed Huffman codes
// go.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace weft::test {

// Correct in every byte: whoever decodes it gets width × height texels.
[[nodiscard]] std::string black_png(uint32_t width_px, uint32_t height_px);

// As the header says one texel, of which the data inflates to `data_bytes`.
[[nodiscard]] std::string swollen_png(uint64_t data_bytes);

// A chunk with its length and checksum.
[[nodiscard]] std::string png_chunk(std::string_view type, std::string_view data);

}  // namespace weft::test
