// Large pictures in small files: PNGs of one bit a texel, all black, compressed as far as fixed Huffman codes
// go.
#pragma once

#include <cstdint>
#include <string>

namespace weft::test {

// Correct in every byte: whoever decodes it gets width × height texels.
[[nodiscard]] std::string black_png(uint32_t width_px, uint32_t height_px);

}  // namespace weft::test
